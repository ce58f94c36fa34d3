#include "start/RobotSearch.hpp"

#include "io/Programs.hpp"
#include "robot/RobotClient.hpp"

#include <algorithm>
#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace naocal {

namespace {

using Json = nlohmann::json;
using Tcp = boost::asio::ip::tcp;

constexpr std::size_t mostAnnounced = 64;

/// Undoes avahi's escapes: \046 for ".", "\\" for a backslash.
std::string unescape(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char code = 0;
    const char* const digits = text.data() + i + 1;
    if (text[i] == '\\' && i + 3 < text.size() && std::from_chars(digits, digits + 3, code).ptr == digits + 3) {
      plain += static_cast<char>(code);
      i += 3;
    } else if (text[i] == '\\' && i + 1 < text.size()) {
      plain += text[++i];
    } else {
      plain += text[i];
    }
  }
  return plain;
}

/// One listed address that is being asked: resolved, then connected to; nothing is sent.
struct Asked : std::enable_shared_from_this<Asked> {
  Asked(boost::asio::io_context& context, std::string listed, std::function<void()> call)
      : address{std::move(listed)}, changed{std::move(call)}, resolver{context}, socket{context}, patience{context} {}

  void ask() {
    const RobotAddress place = parseRobotAddress(address);
    if (!place.folder.empty()) {
      std::error_code ignored;
      const bool isThere = std::filesystem::exists(std::filesystem::path{place.folder} / "config", ignored);
      isThere ? settle("answers", "has its sockets here") : settle("silent", "has no sockets there");
      return;
    }
    patience.expires_after(RobotSearch::longestAnswer);
    patience.async_wait([self = shared_from_this()](boost::system::error_code stopped) {
      if (!stopped) {
        self->settle("silent", "does not answer");
      }
    });
    resolver.async_resolve(Tcp::v4(), place.host, std::to_string(place.basePort + 2),
                           [self = shared_from_this()](boost::system::error_code error, const auto& found) {
                             error ? self->settle("silent", "is not a known name") : self->connect(found);
                           });
  }

  void connect(const Tcp::resolver::results_type& found) {
    if (state == "asking") {
      boost::asio::async_connect(socket, found, [self = shared_from_this()](boost::system::error_code error, auto&&) {
        if (!error) {
          self->settle("answers", "naocal answers");
        } else if (error == boost::asio::error::connection_refused) {
          self->settle("silent", "is there, but naocal does not run on it");
        } else {
          self->settle("silent", "does not answer");
        }
      });
    }
  }

  void settle(const char* found, const char* words) {
    if (state == "asking") {
      state = found;
      sentence = words;
      patience.cancel();
      resolver.cancel();
      boost::system::error_code ignored;
      socket.close(ignored);
      if (changed) {
        changed();
      }
    }
  }

  std::string address, state = "asking", sentence = "is being asked";
  std::function<void()> changed;
  Tcp::resolver resolver;
  Tcp::socket socket;
  boost::asio::steady_timer patience;
};

} // namespace

std::vector<AnnouncedRobot> parseAnnouncements(const std::deque<std::string>& lines) {
  std::vector<AnnouncedRobot> robots;
  for (const std::string& line : lines) {
    std::vector<std::string> fields;
    std::istringstream text{line};
    for (std::string field; std::getline(text, field, ';');) {
      fields.push_back(field);
    }
    const bool isResolved = fields.size() >= 9 && fields[0] == "=" && fields[2] == "IPv4" && !fields[7].empty();
    const auto isSame = [&](const AnnouncedRobot& robot) { return robot.address == fields[7]; };
    if (isResolved && robots.size() < mostAnnounced && std::none_of(robots.begin(), robots.end(), isSame)) {
      robots.push_back({unescape(fields[3]), fields[7]});
    }
  }
  return robots;
}

struct RobotSearch::Implementation {
  Implementation(boost::asio::io_context& given, std::function<void()> call)
      : context{given}, changed{std::move(call)}, browseEnd{given}, browser{given, "avahi-browse",
                                                                            findProgram("avahi-browse"),
                                                                            [this] { changed(); }} {}

  void search(const std::vector<std::string>& addresses) {
    for (const std::string& address : addresses) {
      parseRobotAddress(address); // throws
    }
    forget();
    for (const std::string& address : addresses) {
      asked.push_back(std::make_shared<Asked>(context, address, changed));
    }
    for (const auto& one : asked) {
      one->ask();
    }
    if (browser.program() && !browser.isRunning()) {
      browser.start({"--resolve", "--parsable", "--terminate", "_nao._tcp"});
      browseEnd.expires_after(longestBrowse);
      browseEnd.async_wait([this](boost::system::error_code stopped) {
        if (!stopped) {
          browser.end(SIGTERM);
        }
      });
    }
    hasSearched = true;
    changed();
  }

  void forget() {
    for (const auto& one : asked) {
      one->changed = nullptr;
      one->settle("silent", "");
    }
    asked.clear();
  }

  std::string note() const {
    if (!browser.program()) {
      return "NAOs that announce themselves cannot be listed: avahi-browse (package avahi-utils) is not installed. "
             "List their addresses instead.";
    }
    const bool wasEnded = browser.exitCode() == -1; // after `longestBrowse`
    return wasEnded || browser.failure().empty()
               ? ""
               : fmt::format("NAOs that announce themselves cannot be listed: {}", browser.failure());
  }

  boost::asio::io_context& context;
  std::function<void()> changed;
  std::vector<std::shared_ptr<Asked>> asked;
  bool hasSearched = false;
  boost::asio::steady_timer browseEnd;
  ChildProgram browser;
};

RobotSearch::RobotSearch(boost::asio::io_context& context, std::function<void()> changed)
    : implementation_{std::make_unique<Implementation>(context, std::move(changed))} {}

RobotSearch::~RobotSearch() {
  implementation_->forget();
}

void RobotSearch::search(const std::vector<std::string>& addresses) {
  implementation_->search(addresses);
}

Json RobotSearch::state() const {
  const Implementation& now = *implementation_;
  Json listed = Json::array(), announced = Json::array();
  bool isSearching = now.browser.isRunning();
  for (const auto& one : now.asked) {
    listed.push_back({{"address", one->address}, {"state", one->state}, {"sentence", one->sentence}});
    isSearching = isSearching || one->state == "asking";
  }
  for (const AnnouncedRobot& robot : parseAnnouncements(now.browser.lines())) {
    announced.push_back({{"name", robot.name}, {"address", robot.address}});
  }
  return {{"searching", isSearching},
          {"searched", now.hasSearched},
          {"listed", listed},
          {"announced", announced},
          {"note", now.note()}};
}

} // namespace naocal

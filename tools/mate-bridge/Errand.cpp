#include "Errand.hpp"

#include "Programs.hpp"
#include "Wire.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr std::size_t mostLines = 300, longestLine = 500, mostWords = 64;

/// Those that need no answers while they run.
const std::set<std::string> commands{"poses",   "simulate", "detect",   "solve", "compare",
                                     "effects", "diagnose", "evaluate", "report"};

} // namespace

/// Lives on while something is still to be read.
struct Errand::Running : std::enable_shared_from_this<Running> {
  Running(boost::asio::io_context& given, std::optional<std::filesystem::path> path, Tell call)
      : program{std::move(path)}, tell{std::move(call)}, output{given}, soon{given} {}

  void start(const std::vector<std::string>& asked) {
    if (!program) {
      throw InputError{
          "the program naocal was not found beside mate-bridge, nor where the shell looks: install it too"};
    }
    if (process != 0) {
      throw InputError{"a command is running: wait for it, or end it"};
    }
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw InputError{fmt::format("no pipe can be made: {}", std::strerror(errno))};
    }
    try {
      process = started(*program, asked, ends[1]);
    } catch (...) {
      close(ends[0]);
      close(ends[1]);
      throw;
    }
    close(ends[1]);
    output.assign(ends[0]);
    words = asked;
    lines.assign(1, "");
    exitCode.reset();
    ending = false;
    tellNow();
    read();
  }

  void end(int signal) const {
    if (process != 0) {
      kill(-process, signal);
    }
  }

  void read() {
    output.async_read_some(boost::asio::buffer(part),
                           [self = shared_from_this()](boost::system::error_code error, std::size_t count) {
                             self->add({self->part.data(), count});
                             error ? self->ended() : self->read();
                           });
  }

  /// A carriage return begins the line anew, as progress does.
  void add(std::string_view text) {
    for (const char letter : text) {
      if (letter == '\n') {
        lines.emplace_back();
        returned = false;
      } else if (letter == '\r') {
        returned = true;
      } else {
        if (std::exchange(returned, false)) {
          lines.back().clear();
        }
        if (lines.back().size() < longestLine) {
          lines.back() += letter;
        }
      }
      if (lines.size() > mostLines) {
        lines.pop_front();
      }
    }
    if (!std::exchange(told, true)) { // at most five times a second
      soon.expires_after(std::chrono::milliseconds{200});
      soon.async_wait([self = shared_from_this()](boost::system::error_code) { self->tellNow(); });
    }
  }

  void ended() {
    output.close();
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    process = 0;
    tellNow();
  }

  void tellNow() {
    told = false;
    if (tell) {
      tell(latest());
    }
  }

  std::string latest() const {
    return wireText({{"kind", "errand"},
                     {"program", program ? Json(program->string()) : Json(nullptr)},
                     {"folder", std::filesystem::current_path().string()},
                     {"words", words},
                     {"lines", lines},
                     {"running", process != 0},
                     {"ending", ending},
                     {"exitCode", exitCode ? Json(*exitCode) : Json(nullptr)}});
  }

  std::optional<std::filesystem::path> program;
  Tell tell;
  boost::asio::posix::stream_descriptor output;
  boost::asio::steady_timer soon;
  std::array<char, 4096> part{};
  pid_t process = 0;
  std::vector<std::string> words;
  std::deque<std::string> lines;
  bool returned = false, told = false, ending = false;
  std::optional<int> exitCode;
};

Errand::Errand(boost::asio::io_context& context, std::optional<std::filesystem::path> program, Tell tell)
    : running_{std::make_shared<Running>(context, std::move(program), std::move(tell))} {}

Errand::~Errand() {
  running_->tell = nullptr;
  running_->end(SIGTERM);
}

bool Errand::asked(const Json& request) {
  const std::string verb = request.at("do");
  if (verb == "endRun") {
    running_->end(running_->ending ? SIGTERM : SIGINT);
    running_->ending = true;
    running_->tellNow();
    return true;
  }
  if (verb != "run") {
    return false;
  }
  const std::vector<std::string> words = request.at("words");
  if (words.empty() || words.size() > mostWords || !commands.contains(words.front())) {
    throw InputError{fmt::format("expected one of naocal's commands ({}) and its options, found \"{}\"",
                                 fmt::join(commands, ", "), fmt::join(words, " "))};
  }
  running_->start(words);
  return true;
}

std::string Errand::latest() const {
  return running_->latest();
}

} // namespace naocal

#include "start/RobotSearch.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace naocal;
using Catch::Contains;
using Json = nlohmann::json;
using Tcp = boost::asio::ip::tcp;

namespace {

/// A folder alone on the PATH, so that no search reaches the network; restored at the end.
class OnlyProgram {
public:
  /// `script`: content of avahi-browse; empty: there is none.
  explicit OnlyProgram(const std::string& script) : before_{std::getenv("PATH")} {
    if (!script.empty()) {
      const std::filesystem::path program = folder_.path() / "avahi-browse";
      std::ofstream{program} << "#!/bin/sh\n" << script;
      std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    }
    ::setenv("PATH", folder_.path().c_str(), 1);
  }
  ~OnlyProgram() { ::setenv("PATH", before_.c_str(), 1); }

private:
  TemporaryDirectory folder_;
  std::string before_;
};

/// The state after a search of these addresses has ended; at most a minute.
Json afterSearch(const std::vector<std::string>& addresses) {
  boost::asio::io_context context;
  RobotSearch search{context, [] {}};
  search.search(addresses);
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{1};
  while (search.state()["searching"].get<bool>() && std::chrono::steady_clock::now() < end) {
    context.run_one_for(std::chrono::milliseconds{50});
    context.restart();
  }
  return search.state();
}

} // namespace

TEST_CASE("robots that announce themselves are read from avahi-browse") {
  // Proves it for the parsable lines of avahi-browse; that NAOs announce themselves so is not tested.
  const auto robots = parseAnnouncements(
      {"+;eth0;IPv4;nao21;_nao._tcp;local", "=;eth0;IPv6;nao21;_nao._tcp;local;nao21.local;fe80::1;9559;",
       R"(=;eth0;IPv4;nao\0321\.a\\b;_nao._tcp;local;nao21.local;10.1.24.21;9559;"x")",
       "=;wlan0;IPv4;nao21;_nao._tcp;local;nao21.local;10.1.24.21;9559;", "=;;;", ""});
  REQUIRE(robots.size() == 1);
  CHECK(robots[0].name == R"(nao 1.a\b)");
  CHECK(robots[0].address == "10.1.24.21");
}

TEST_CASE("listed addresses are asked whether naocal listens there") {
  // Proves it on this computer for a listening port, a closed one, and folders with and without sockets.
  const OnlyProgram none{""};
  boost::asio::io_context own;
  const Tcp::acceptor robot{own, Tcp::endpoint{boost::asio::ip::address_v4::loopback(), 0}};
  const unsigned port = robot.local_endpoint().port() - 2; // the configuration's port is two above the base port
  const TemporaryDirectory sockets;
  writeAtomically(sockets.path() / "config", "");
  const Json state =
      afterSearch({fmt::format("127.0.0.1:{}", port), "127.0.0.1:1", sockets.path().string(), "/no/such"});
  CHECK(state["listed"][0]["state"] == "answers");
  CHECK(state["listed"][1]["state"] == "silent");
  CHECK(state["listed"][1]["sentence"] == "is there, but naocal does not run on it");
  CHECK(state["listed"][2]["state"] == "answers");
  CHECK(state["listed"][3]["state"] == "silent");
  CHECK_THAT(state["note"].get<std::string>(), Contains("avahi-browse (package avahi-utils) is not installed"));
}

TEST_CASE("an address that cannot be one is refused before anything is asked") {
  // Proves that the search keeps its state.
  const OnlyProgram none{""};
  boost::asio::io_context context;
  RobotSearch search{context, [] {}};
  CHECK_THROWS_WITH(search.search({"127.0.0.1:1", "nao 21"}), Contains("expected a robot's name"));
  CHECK(search.state()["listed"].empty());
  CHECK(search.state()["searched"] == false);
}

TEST_CASE("the program that lists announced robots is asked for NAOs, and its failure is said") {
  // Proves its options, its output's way into the state, and the sentence of a failure. Its time limit is not tested.
  {
    const OnlyProgram avahi{"[ \"$*\" = '--resolve --parsable --terminate _nao._tcp' ] || exit 1\n"
                            "echo '=;eth0;IPv4;nao21;_nao._tcp;local;nao21.local;10.1.24.21;9559;'\n"};
    const Json state = afterSearch({});
    REQUIRE(state["announced"].size() == 1);
    CHECK(state["announced"][0]["name"] == "nao21");
    CHECK(state["note"] == "");
  }
  const OnlyProgram avahi{"echo 'Failed to create client object: Daemon not running' >&2\nexit 1\n"};
  CHECK_THAT(afterSearch({})["note"].get<std::string>(), Contains("cannot be listed: Failed to create client object"));
}

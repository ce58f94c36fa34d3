#include "framework/network/ClientLimits.hpp"

#include "ConfigNumbers.hpp"
#include "DebugNumbers.hpp"
#include "framework/ShownRobot.hpp"
#include "framework/network/Connection.hpp"

#include <boost/asio/io_context.hpp>
#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace naocal {
namespace {

using nlohmann::json;

/// Protocol that counts messages and ends of one client.
struct Counting : Protocol {
  const FrameFormat& format() const override { return debugFormat; }
  void onOpened(Peer&) override {}
  void onReceived(Peer&, std::uint8_t, std::string) override { ++messages; }
  void onClosed(Peer&) override { isClosed = true; }
  bool isTrusted(const Peer&) const override { return true; }
  bool needsSecret(const std::string&) const override { return false; }
  bool isInUse(const Peer&) const override { return false; }
  bool mayBeSilent(const Peer&) const override { return true; }
  int messages = 0;
  bool isClosed = false;
};

/// A connection over a pair of sockets, run by the test.
struct Paired {
  explicit Paired(const ClientLimits& limits = {}) {
    REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
    connection = std::make_shared<Connection>(
        Socket{context, boost::asio::generic::stream_protocol{AF_UNIX, 0}, ends[0]}, "", protocol, limits,
        [this](std::string_view sentence) { said = sentence; }, [](Connection&) {});
    connection->start();
  }
  ~Paired() {
    connection->end();
    context.poll();
    ::close(ends[1]);
  }
  boost::asio::io_context context;
  Counting protocol;
  std::string said; // last sentence of the log
  int ends[2]{};
  std::shared_ptr<Connection> connection;
};

} // namespace

TEST_CASE("a message has at most the bytes that its socket allows") {
  // Proves both sockets' limits at their boundary: the largest message is answered or refused for what it says, one of
  // a byte more is closed by its header.
  ShownRobot robot;
  auto debug = robot.debug();
  const std::string list = R"({"keys": []})";
  debug.send(subscribeBulk, list + std::string((1 << 16) - list.size(), ' '));
  debug.send(requestList);
  CHECK(debug.receive(naocal::list).has_value());
  debug.send(subscribe, std::string((1 << 16) + 1, 'a'));
  CHECK(debug.isClosed());
  CHECK(robot.isLogged("expected at most 65536 bytes in a frame, found 65537 announced"));
  auto config = robot.config();
  config.send(set, "[]" + std::string((1 << 20) - 2, ' '));
  config.send(getMounts);
  CHECK(config.receive(sendMounts).has_value());
  config.send(set, "[]" + std::string((1 << 20) - 1, ' '));
  CHECK(config.isClosed());
  CHECK(robot.isLogged("expected at most 1048576 bytes in a frame, found 1048577 announced"));
}

TEST_CASE("a client may send a burst of twice its messages per second, and no more") {
  // Proves both sides for a burst that is sent at once: as many as are allowed arrive; more than that and what accrues
  // during the test never do.
  ClientLimits limits;
  limits.messagesPerSecond = 50;
  Paired one{limits};
  std::string burst;
  for (int i = 0; i < 100; ++i) {
    burst += encodeDebugFrame(DebugType::requestList, "");
  }
  REQUIRE(::send(one.ends[1], burst.data(), burst.size(), MSG_NOSIGNAL) == ssize_t(burst.size()));
  one.context.poll();
  CHECK(one.protocol.messages == 100);
  CHECK_FALSE(one.protocol.isClosed);
  Paired other{limits};
  for (int i = 0; i < 10; ++i) {
    REQUIRE(::send(other.ends[1], burst.data(), burst.size(), MSG_NOSIGNAL) == ssize_t(burst.size()));
  }
  const TimePoint begin = Clock::now();
  other.context.poll();
  CHECK(other.protocol.messages <= 100 + 1 + 50 * toSeconds(Clock::now() - begin));
  CHECK(other.protocol.isClosed);
  CHECK(other.said ==
        "Client on this computer: expected at most 50 messages per second, found more; the connection was "
        "closed.");
}

TEST_CASE("a client that does not read may owe eight megabytes, and no byte more") {
  // Proves the boundary: the first message, of which the system takes a part, counts as a whole until it is taken.
  Paired one;
  const std::size_t most = ClientLimits{}.maxPendingBytes;
  const auto half = std::make_shared<const std::string>(std::string(most / 2, 'x'));
  one.connection->send(half);
  REQUIRE(one.connection->isBusy());
  one.connection->send(half);
  one.context.poll();
  CHECK_FALSE(one.protocol.isClosed);
  one.connection->send(std::make_shared<const std::string>("x"));
  one.context.poll();
  CHECK(one.protocol.isClosed);
  CHECK(one.said.find("asks for answers and does not read them") != std::string::npos);
}

TEST_CASE("a client has at most its number of subscriptions, of keys of a limited length") {
  // Proves both at their boundary: the longest key, and the last subscription that is allowed, are taken.
  ShownRobot robot{{.messagesPerSecond = 1e9}};
  auto client = robot.debug();
  client.send(subscribe, std::string(256, 'a'));
  for (int i = 1; i < 1000; ++i) {
    client.send(subscribe, fmt::format("Brain.later{}", i));
  }
  client.send(subscribe, "Brain.later1"); // again
  client.send(requestList);
  CHECK(client.receive(list).has_value());
  client.send(subscribe, "Brain.one too many");
  CHECK(client.isClosed());
  CHECK(robot.isLogged("expected at most 1000 subscriptions of one client, found more"));
}

TEST_CASE("as many clients as the robot has places keep them, and the next one is let in") {
  // Proves the shipped numbers at their boundary, on both sockets, with clients that use their places: twenty stay, and
  // one more takes the place of one of the last four.
  ShownRobot robot;
  const std::size_t places = robot.settings.maxClients + robot.settings.keptPlaces;
  REQUIRE(places == 20);
  std::vector<MateClient> watching, owning;
  const json will = {{{"mp", "Brain.Counter"}, {"key", "factor"}, {"value", 1.0}}};
  const json leaving = {{{"mp", "naocal.configuration"}, {"key", "lastWill"}, {"value", will}}};
  for (std::size_t i = 0; i < places; ++i) {
    watching.push_back(robot.debug());
    watching.back().send(subscribe, "Brain.count");
    owning.push_back(robot.config());
    owning.back().send(set, leaving.dump());
  }
  const auto answers = [](MateClient& client, int request, int answer) {
    client.send(request);
    return client.receive(answer).has_value();
  };
  for (std::size_t i = 0; i < places; ++i) {
    CAPTURE(i);
    CHECK(answers(watching[i], requestList, list));
    CHECK(answers(owning[i], getMounts, sendMounts));
  }
  auto watcher = robot.debug();
  auto owner = robot.config();
  CHECK(answers(watcher, requestList, list));
  CHECK(answers(owner, getMounts, sendMounts));
  CHECK(watching[robot.settings.maxClients].isClosed()); // of the last four the one silent the longest
  CHECK(owning[robot.settings.maxClients].isClosed());
  for (std::size_t i = 0; i < robot.settings.maxClients; ++i) {
    CAPTURE(i);
    CHECK(answers(watching[i], requestList, list));
    CHECK(answers(owning[i], getMounts, sendMounts));
  }
}

} // namespace naocal

#include "DebugNumbers.hpp"
#include "framework/ShownRobot.hpp"
#include "framework/network/Access.hpp"
#include "framework/network/ConfigServer.hpp"
#include "framework/network/Connection.hpp"
#include "framework/network/DebugServer.hpp"
#include "protocol/Frames.hpp"

#include <boost/asio/io_context.hpp>
#include <catch2/catch.hpp>
#include <new>

namespace naocal {
namespace {

using nlohmann::json;

/// A network client that accepts all data and sends nothing.
class QuietPeer : public Peer {
public:
  void send(std::shared_ptr<const std::string>) override {}
  bool isBusy() const override { return false; }
  const std::string& address() const override { return address_; }

private:
  std::string address_ = "10.1.24.7";
};

/// Memory in which one client follows another at the same address, as it may happen on a busy robot.
struct OnePlace {
  std::shared_ptr<Peer> next() {
    return {new (memory) QuietPeer, [](QuietPeer* peer) { peer->~QuietPeer(); }};
  }
  alignas(QuietPeer) std::byte memory[sizeof(QuietPeer)];
};

/// Protocol that counts frames of open and of closed clients. They may be silent if `isPatient`.
struct Counted : Protocol {
  const FrameFormat& format() const override { return debugFormat; }
  void onOpened(Peer&) override {}
  void onReceived(Peer&, std::uint8_t, std::string) override { ++(isClosed ? late : timely); }
  void onClosed(Peer&) override { isClosed = true; }
  bool isTrusted(const Peer&) const override { return true; }
  bool needsSecret(const std::string&) const override { return false; }
  bool isInUse(const Peer&) const override { return false; }
  bool mayBeSilent(const Peer&) const override { return isPatient; }
  int timely = 0, late = 0;
  bool isClosed = false, isPatient = false;
};

/// A connection with one pending frame, driven step by step.
struct SteppedConnection {
  SteppedConnection() {
    REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
    connection = std::make_shared<Connection>(
        Socket{context, boost::asio::generic::stream_protocol{AF_UNIX, 0}, ends[0]}, "", protocol, ClientLimits{},
        [](std::string_view) {}, [](Connection&) {});
    const std::string frame = encodeDebugFrame(DebugType::subscribe, "Brain.count");
    REQUIRE(::send(ends[1], frame.data(), frame.size(), MSG_NOSIGNAL) == ssize_t(frame.size()));
    connection->start();
  }
  ~SteppedConnection() {
    connection->end();
    context.poll();
    ::close(ends[1]);
  }
  boost::asio::io_context context;
  Counted protocol;
  int ends[2]{};
  std::shared_ptr<Connection> connection;
};

std::string secretMessage(const std::string& secret) {
  return json{{{"mp", "naocal.access"}, {"key", "secret"}, {"value", secret}}}.dump();
}

} // namespace

TEST_CASE("a frame that was read before its connection ended is dropped") {
  // Proves it for an end at each step of a frame's processing, including the last one, when the frame has been read and
  // ending the connection cannot stop it.
  int steps = 0;
  SteppedConnection undisturbed;
  for (; undisturbed.protocol.timely == 0; ++steps) {
    REQUIRE(undisturbed.context.run_one() == 1);
  }
  for (int before = 0; before < steps; ++before) {
    CAPTURE(before);
    SteppedConnection one;
    for (int step = 0; step < before; ++step) {
      one.context.run_one();
    }
    one.connection->end();
    one.context.run();
    CHECK(one.protocol.isClosed);
    CHECK(one.protocol.timely == 0);
    CHECK(one.protocol.late == 0);
  }
}

TEST_CASE("a connection without a message in time is closed") {
  // Proves both limits at their boundary, with given times, and that a client that may be silent is not closed. Half a
  // message is none.
  const ClientLimits limits;
  const auto soon = std::chrono::milliseconds{1};
  SteppedConnection one;
  const TimePoint start = one.connection->lastMessage();
  one.connection->closeIfSilent(start + limits.firstMessage - soon);
  CHECK_FALSE(one.protocol.isClosed);
  one.connection->closeIfSilent(start + limits.firstMessage);
  CHECK(one.protocol.isClosed);
  for (const bool isPatient : {false, true}) {
    SteppedConnection other;
    other.protocol.isPatient = isPatient;
    while (other.protocol.timely == 0) {
      REQUIRE(other.context.run_one() == 1);
    }
    const TimePoint heard = other.connection->lastMessage();
    REQUIRE(::send(other.ends[1], "DMSG", 4, MSG_NOSIGNAL) == 4);
    other.context.poll();
    other.connection->closeIfSilent(heard + limits.rest - soon);
    CHECK_FALSE(other.protocol.isClosed);
    other.connection->closeIfSilent(heard + limits.rest);
    CHECK(other.protocol.isClosed == !isPatient);
  }
}

TEST_CASE("a debug client that has left wants nothing any more, whatever still comes from it") {
  // Proves it for every kind of request, at the server itself; the next cycle would write to freed memory.
  ShownRobot robot;
  robot.sockets.reset();
  Access access{{}};
  DebugServer server{{&robot.brain}, access, robot.base};
  const AnyProduction* count = robot.database.find("Brain.count");
  const std::pair<int, std::string> requests[] = {
      {subscribe, "Brain.count"}, {subscribeBulk, R"({"keys": ["Brain.count"]})"}, {unsubscribe, "Brain.picture"}};
  for (const auto& [type, body] : requests) {
    auto peer = std::make_shared<QuietPeer>();
    server.onOpened(*peer);
    server.onReceived(*peer, subscribe, "Brain.count");
    CHECK(count->isWanted());
    server.onClosed(*peer);
    server.onReceived(*peer, std::uint8_t(type), body);
    CHECK_FALSE(count->isWanted());
    CHECK(peer.use_count() == 1);
  }
}

TEST_CASE("a client at the address in memory of one that showed the secret has not shown it") {
  // Proves it for a secret that arrives after the end of its connection, and for a server that was not notified of the
  // end. Such a client neither keeps its network address unlocked nor leaves a last will.
  ConfiguredRobot robot;
  robot.file("default/head/default/Counter.json", R"({"factor": 0.5})");
  robot.configuration.mount("Brain.Counter", "Counter.json", RobotPart::head);
  Access access{{"0.0.0.0", "open sesame", false}};
  ConfigServer server{robot.configuration, access, [](std::string_view) {}};
  const json will = {{{"mp", "Brain.Counter"}, {"key", "factor"}, {"value", 7.0}}};
  const json leaving = {{{"mp", "naocal.configuration"}, {"key", "lastWill"}, {"value", will}}};
  OnePlace place;
  auto late = place.next();
  server.onOpened(*late);
  server.onClosed(*late);
  server.onReceived(*late, 0, secretMessage("open sesame"));
  server.continueMessage(*late);
  server.onReceived(*late, 0, leaving.dump());
  server.continueMessage(*late);
  CHECK_FALSE(access.isOpen(late->address()));
  late.reset();
  auto forgotten = place.next();
  server.onOpened(*forgotten);
  CHECK_FALSE(server.isTrusted(*forgotten));
  server.onReceived(*forgotten, 0, secretMessage("open sesame"));
  server.continueMessage(*forgotten);
  CHECK(server.isTrusted(*forgotten));
  forgotten.reset();
  auto stranger = place.next();
  server.onOpened(*stranger);
  CHECK_FALSE(server.isTrusted(*stranger));
  server.onClosed(*stranger);
  CHECK(robot.readKeys("Brain.Counter")["factor"] == 0.5);
}

TEST_CASE("a message with many settings lets other clients in between") {
  // Proves, at the server itself, that a message of the largest number is set in parts, that another client's setting
  // takes effect between them, and that a message with one more is refused as a whole.
  ConfiguredRobot robot;
  robot.file("default/head/default/Counter.json", R"({"factor": 0.5, "gain": 1})");
  robot.configuration.mount("Brain.Counter", "Counter.json", RobotPart::head);
  Access access{{}};
  ConfigServer server{robot.configuration, access, [](std::string_view) {}};
  const auto messageOf = [](std::size_t settings) {
    json message = json::array();
    for (std::size_t i = 1; i <= settings; ++i) {
      message.push_back({{"mp", "Brain.Counter"}, {"key", "factor"}, {"value", i}});
    }
    return message.dump();
  };
  const auto busy = std::make_shared<QuietPeer>(), other = std::make_shared<QuietPeer>();
  server.onOpened(*busy);
  server.onOpened(*other);
  server.onReceived(*busy, 0, messageOf(ConfigServer::mostSettings));
  REQUIRE(server.continueMessage(*busy));
  CHECK(robot.readKeys("Brain.Counter")["factor"] == ConfigServer::settingsPerTurn);
  server.onReceived(*other, 0, R"([{"mp": "Brain.Counter", "key": "gain", "value": 2}])");
  CHECK_FALSE(server.continueMessage(*other));
  CHECK(robot.readKeys("Brain.Counter")["gain"] == 2);
  std::size_t turns = 2;
  while (server.continueMessage(*busy)) {
    ++turns;
  }
  CHECK(turns == ConfigServer::mostSettings / ConfigServer::settingsPerTurn);
  CHECK(robot.readKeys("Brain.Counter")["factor"] == ConfigServer::mostSettings);
  CHECK_THROWS_WITH(server.onReceived(*busy, 0, messageOf(ConfigServer::mostSettings + 1)),
                    "expected at most 1000 settings in a message, found 1001");
  CHECK_FALSE(server.continueMessage(*busy));
}

TEST_CASE("a last will is bounded") {
  // Proves the number of its settings at the boundary; beyond it the earlier will remains.
  ConfiguredRobot robot;
  robot.file("default/head/default/Counter.json", R"({"factor": 0.5})");
  robot.configuration.mount("Brain.Counter", "Counter.json", RobotPart::head);
  Access access{{}};
  std::vector<std::string> sentences;
  ConfigServer server{robot.configuration, access,
                      [&](std::string_view sentence) { sentences.emplace_back(sentence); }};
  const auto peer = std::make_shared<QuietPeer>();
  server.onOpened(*peer);
  const auto leave = [&](std::size_t settings, double value) {
    const json last(settings, {{"mp", "Brain.Counter"}, {"key", "factor"}, {"value", value}});
    server.onReceived(*peer, 0, json{{{"mp", "naocal.configuration"}, {"key", "lastWill"}, {"value", last}}}.dump());
    server.continueMessage(*peer);
  };
  leave(ConfigServer::mostWillSettings, 3);
  CHECK(server.isInUse(*peer));
  CHECK(sentences.empty());
  leave(ConfigServer::mostWillSettings + 1, 4);
  REQUIRE(sentences.size() == 1);
  CHECK(sentences[0].find("expected at most 100 settings in a last will, found 101") != std::string::npos);
  server.onClosed(*peer);
  CHECK(robot.readKeys("Brain.Counter")["factor"] == 3);
}

TEST_CASE("clients that come, ask and leave at once leave nothing behind while values flow", "[slow]") {
  // Proves it with real sockets: for 1.5 s the robot cycles for one client, while hundreds of others subscribe, request
  // the list, unsubscribe and disconnect without reading, in MATE's frames. A leftover subscription shows as a wanted
  // production, or crashes this program.
  ShownRobot robot{{.maxClients = 2000}}; // disconnected clients may be noticed late
  auto onlooker = robot.debug();
  onlooker.send(subscribe, "Brain.count");
  std::string requests = onlooker.frame(subscribe, "Brain.Counter.scaled");
  for (int i = 0; i < 20; ++i) {
    requests += onlooker.frame(requestList, "") + onlooker.frame(unsubscribe, "a") +
                onlooker.frame(subscribeBulk, R"({"keys": ["Brain.history", "b"]})");
  }
  std::atomic<bool> stop = false;
  std::thread reader{[&] {
    while (onlooker.receive()) {
    }
  }};
  std::thread cycles{[&] {
    while (!stop) {
      robot.brain.cycle();
      std::this_thread::sleep_for(std::chrono::microseconds{50});
    }
  }};
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds{1500};
  while (std::chrono::steady_clock::now() < end) {
    std::vector<MateClient> leaving;
    for (int i = 0; i < 8; ++i) {
      leaving.push_back(robot.debug());
    }
    for (MateClient& client : leaving) {
      client.sendBytes(requests);
    }
  }
  stop = true;
  cycles.join();
  auto last = robot.debug();
  const auto wanted = [&](const char* key) {
    const AnyProduction* production = robot.database.find(key);
    for (int i = 0; i < 1000 && production->isWanted(); ++i) {
      last.send(requestList); // until the server has noticed all disconnections
      last.receive(list);
    }
    return production->isWanted();
  };
  CHECK_FALSE(wanted("Brain.Counter.scaled"));
  CHECK_FALSE(wanted("Brain.history"));
  CHECK(robot.database.find("Brain.count")->isWanted());
  robot.sockets.reset();
  reader.join();
}

} // namespace naocal

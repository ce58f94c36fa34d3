#include "framework/ShownRobot.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace naocal {
namespace {

using nlohmann::json;

/// Whether both servers still reply to a correct client.
bool isAlive(const ShownRobot& robot) {
  auto debug = robot.debug();
  debug.send(3);
  auto config = robot.config();
  config.send(2, "Brain.Counter");
  return debug.receiveJson(4)["keys"].size() == 6 && config.receiveJson(4)["keys"].size() == 2;
}

std::string withByte(std::string bytes, std::size_t index, int value) {
  bytes[index] = static_cast<char>(value);
  return bytes;
}

} // namespace

TEST_CASE("a bad frame closes its client with a sentence and nobody else") {
  // Pins the messages for each field of a header, and for bodies that do not match their type.
  ShownRobot robot;
  auto bystander = robot.debug();
  const auto refused = [&](MateClient client, const std::string& bytes, const std::string& sentence) {
    CAPTURE(sentence);
    client.sendBytes(bytes);
    CHECK(client.isClosed());
    CHECK(robot.isLogged("Client 127.0.0.1: " + sentence));
  };
  const std::string debug = bystander.frame(3, "");
  refused(robot.debug(), withByte(debug, 0, 'X'),
          "expected the four letters DMSG at the start of a frame, found others");
  refused(robot.debug(), withByte(debug, 4, 2), "expected version 1 of the protocol, found 2");
  refused(robot.debug(), withByte(debug, 5, 7), "expected a message type from 0 to 6, found 7");
  refused(robot.debug(), withByte(debug, 5, 2), "expected a request, found message type 2, which only robots send");
  refused(robot.debug(), withByte(debug, 11, 1), "expected at most 65536 bytes in a frame, found 16777216 announced");
  refused(robot.debug(), bystander.frame(5, "{\"keys\": [1]}"), "expected {\"keys\": [..]} with texts");
  refused(robot.debug(), bystander.frame(5, "{"), "expected {\"keys\": [..]} with texts");
  const std::string config = robot.config().frame(1, "");
  refused(robot.config(), debug, "expected the four letters CONF at the start of a frame, found others");
  refused(robot.config(), withByte(config, 4, 1), "expected version 2 of the protocol, found 1");
  refused(robot.config(), withByte(config, 11, 1), "expected at most 1048576 bytes in a frame");
  refused(robot.config(), robot.config().frame(0, "[{\"mp\": 1}]"),
          "expected [{\"mp\": mount, \"key\": key, \"value\": value}");
  refused(robot.config(), robot.config().frame(0, std::string(500000, '[')), "expected [{\"mp\": mount");
  refused(robot.config(), robot.config().frame(0, "\xff\xfe"), "expected [{\"mp\": mount");
  bystander.send(3);
  CHECK(bystander.receiveJson(4)["keys"].size() == 6);
}

TEST_CASE("random bytes and broken frames never stop the servers") {
  // Proves it for a thousand clients that send noise, or correct frames modified or truncated, while the robot cycles.
  // Memory errors are detected by the sanitizers on this test.
  ShownRobot robot{{.maxClients = 2000}}; // disconnected clients may be noticed late
  std::mt19937 random{1};
  const auto below = [&](std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>{0, bound - 1}(random);
  };
  const json change = {{{"mp", "Brain.Counter"}, {"key", "list[1]"}, {"value", {{"deep", {1, 2, "three"}}}}}};
  for (int i = 0; i < 1000; ++i) {
    auto client = below(2) == 0 ? robot.debug() : robot.config();
    std::string bytes;
    for (std::size_t frames = below(4) + 1; frames > 0; --frames) {
      const std::vector<std::string> bodies{"", "Brain.count", change.dump(), R"({"keys": ["Brain.picture", "x"]})"};
      bytes += client.frame(int(below(7)), bodies[below(bodies.size())]);
    }
    for (std::size_t changes = below(4); changes > 0; --changes) {
      bytes[below(bytes.size())] = static_cast<char>(below(256));
    }
    if (i % 5 == 0) {
      std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(below(256)); });
    }
    client.sendBytes(bytes.substr(0, below(bytes.size()) + 1));
    robot.brain.cycle();
    if (i % 100 == 99) {
      REQUIRE(isAlive(robot));
    }
  }
}

TEST_CASE("there are limits on clients and on what one may ask per second") {
  // Proves both limits, with their messages; a client that disconnects makes room.
  ShownRobot robot{{.maxClients = 2, .messagesPerSecond = 50, .keptPlaces = 0}};
  auto first = robot.debug();
  first.send(0, "Brain.count");
  first.send(3);
  CHECK(first.receive(4));
  {
    auto second = robot.debug();
    second.send(0, "Brain.count");
    second.send(3);
    CHECK(second.receive(4));
    auto third = robot.debug();
    CHECK(third.isClosed());
    CHECK(robot.isLogged("Client 127.0.0.1: 2 clients are connected already, which is the limit"));
    std::string requests;
    for (int i = 0; i < 1000; ++i) {
      requests += second.frame(3, "");
    }
    second.sendBytes(requests);
    CHECK(second.isClosed());
    CHECK(robot.isLogged("Client 127.0.0.1: expected at most 50 messages per second, found more"));
  }
  CHECK(isAlive(robot));
}

TEST_CASE("a client may subscribe to what does not exist, but not without end") {
  // Proves the limits on the number of subscriptions and the length of keys, which bound the robot's memory.
  ShownRobot robot{{.messagesPerSecond = 1e9}};
  auto client = robot.debug();
  for (int i = 0; i <= 1000; ++i) {
    client.send(0, fmt::format("Brain.later{}", i));
  }
  CHECK(client.isClosed());
  CHECK(robot.isLogged("expected at most 1000 subscriptions of one client, found more"));
  auto wordy = robot.debug();
  wordy.send(0, std::string(257, 'a'));
  CHECK(wordy.isClosed());
  CHECK(robot.isLogged("expected a key of at most 256 letters, found 257"));
}

} // namespace naocal

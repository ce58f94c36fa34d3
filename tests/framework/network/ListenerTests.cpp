#include "ConfigNumbers.hpp"
#include "DebugNumbers.hpp"
#include "framework/ShownRobot.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace naocal {
namespace {

using nlohmann::json;

bool answersDebug(MateClient& client) {
  client.send(requestList);
  return client.receive(list).has_value();
}

bool answersConfig(MateClient& client) {
  client.send(getMounts);
  return client.receive().has_value();
}

json will(double factor) {
  const json last = {{{"mp", "Brain.Counter"}, {"key", "factor"}, {"value", factor}}};
  return {{{"mp", "naocal.configuration"}, {"key", "lastWill"}, {"value", last}}};
}

double factorOf(const ShownRobot& robot) {
  return robot.robot.readKeys("Brain.Counter")["factor"];
}

} // namespace

TEST_CASE("a silent client is closed, and one that waits for its values is not", "[slow]") {
  // Proves both limits with short ones, on both sockets: no message, half a message, a message and no subscription.
  // The subscriber has been silent for longer than a client that came later and was closed for its silence.
  ShownRobot robot{{.firstMessage = std::chrono::milliseconds{1000}, .rest = std::chrono::milliseconds{1500}}};
  auto subscriber = robot.debug();
  subscriber.send(subscribe, "Brain.count");
  auto mate = robot.config();
  REQUIRE(answersConfig(mate));
  CHECK(robot.debug().isClosed());
  CHECK(robot.config().isClosed());
  CHECK(robot.isLogged("Client 127.0.0.1: expected a first message within 1 s, found none"));
  auto slow = robot.debug();
  slow.sendBytes(slow.frame(requestList, "").substr(0, 7));
  CHECK(slow.isClosed());
  auto resting = robot.debug();
  resting.send(requestList);
  CHECK(resting.isClosed());
  CHECK(robot.isLogged("expected a message within 1.5 s of one that wants nothing from the robot, found none"));
  robot.brain.cycle();
  CHECK(subscriber.receive(update).has_value());
  CHECK(answersConfig(mate));
}

TEST_CASE("who wants nothing from the robot gives its place to who comes") {
  // Proves it on both sockets with every place taken: by clients without a message, then by clients that have asked
  // once.
  ShownRobot robot{{.maxClients = 3, .keptPlaces = 1}};
  std::vector<MateClient> silent;
  for (int i = 0; i < 4; ++i) {
    silent.push_back(robot.config());
  }
  std::vector<MateClient> asked;
  for (int i = 0; i < 10; ++i) {
    asked.push_back(robot.config());
    CHECK(answersConfig(asked.back()));
  }
  std::vector<MateClient> lookers;
  for (int i = 0; i < 10; ++i) {
    lookers.push_back(robot.debug());
    CHECK(answersDebug(lookers.back()));
  }
}

TEST_CASE("a client that comes to stop the robot is never shut out") {
  // Proves it where as many clients of the same address as may hold a place hold one for good. The newcomer sets its
  // value; it displaces clients of the kept places only, so the clients that came first leave no last will.
  ShownRobot robot{{.maxClients = 3, .keptPlaces = 2}};
  std::vector<MateClient> holders;
  for (int i = 0; i < 5; ++i) {
    holders.push_back(robot.config());
    holders.back().send(set, will(i < 3 ? 100 + i : 200 + i).dump());
    REQUIRE(answersConfig(holders.back()));
  }
  for (int i = 0; i < 6; ++i) {
    auto operating = robot.config();
    operating.send(set, json{{{"mp", "Brain.Counter"}, {"key", "list[0]"}, {"value", 1000 + i}}}.dump());
    REQUIRE(answersConfig(operating));
    CHECK(robot.robot.readKeys("Brain.Counter")["list"][0] == 1000 + i);
  }
  for (int i = 0; i < 3; ++i) {
    CHECK(answersConfig(holders[std::size_t(i)]));
  }
  CHECK((factorOf(robot) < 100 || factorOf(robot) >= 200));
}

TEST_CASE("strangers push out nobody who is about to send the secret") {
  // Proves it for an owner at another address who hesitates while ten times as many strangers connect as there are
  // places, and that the strangers keep replacing each other.
  SocketSettings settings{.maxClients = 3, .keptPlaces = 1};
  settings.access = {"0.0.0.0", "open sesame", false};
  ShownRobot robot{settings};
  auto owner = MateClient::config(robot.sockets->configPort(), "127.0.0.2");
  std::vector<MateClient> strangers;
  for (int i = 0; i < 40; ++i) {
    strangers.push_back(robot.config());
    CHECK((i % 2 == 0 || answersConfig(strangers.back())));
  }
  owner.send(set, json{{{"mp", "naocal.access"}, {"key", "secret"}, {"value", "open sesame"}}}.dump());
  owner.send(set, json{{{"mp", "Brain.Counter"}, {"key", "factor"}, {"value", 3.0}}}.dump());
  REQUIRE(answersConfig(owner));
  CHECK(factorOf(robot) == 3);
}

TEST_CASE("clients on the network keep nobody from the UNIX socket") {
  // Proves that an address with many clients gives one of its places to another address, even if all are in use.
  ShownRobot robot{{.maxClients = 3, .keptPlaces = 0}};
  std::vector<MateClient> holders;
  for (int i = 0; i < 3; ++i) {
    holders.push_back(robot.debug());
    holders.back().send(subscribe, "Brain.count");
    REQUIRE(answersDebug(holders.back()));
  }
  auto local = MateClient::debug(robot.settings.unixFolder / "debug");
  local.send(subscribe, "Brain.count");
  CHECK(answersDebug(local));
  CHECK(holders[0].isClosed()); // silent for the longest time
  CHECK(robot.debug().isClosed());
  CHECK(answersDebug(local));
}

} // namespace naocal

#include "DebugNumbers.hpp"
#include "framework/ShownRobot.hpp"

#include <catch2/catch.hpp>
#include <future>

namespace naocal {
namespace {

using nlohmann::json;

/// Requests the list; its reply proves that earlier subscriptions are in force.
json listed(MateClient& client) {
  client.send(requestList);
  return client.receiveJson(list);
}

/// An image whose encoding blocks until the test releases it.
struct SlowPicture {
  std::shared_future<void> ready;
};
EncodedImage toImage(const SlowPicture& picture) {
  picture.ready.wait();
  return {1, 1, "slow"};
}

class SlowCamera : public Module {
public:
  explicit SlowCamera(std::shared_future<void> ready) : Module{"SlowCamera"}, ready_{std::move(ready)} {}
  void cycle() override { picture_ = SlowPicture{ready_}; }

private:
  std::shared_future<void> ready_;
  Production<SlowPicture> picture_{*this, "slowPicture"};
};

using namespace std::chrono_literals;

/// Publishes its cycle count always, `news` and images on request.
class Reporter : public Module {
public:
  explicit Reporter(TimePoint base) : Module{"Reporter"}, time{base} {}
  void cycle() override {
    time += 12ms;
    setCycleTime(time);
    count_ = *count_ + 1;
    if (news) {
      news_ = *std::exchange(news, std::nullopt);
    }
    if (const std::size_t size = std::exchange(picture, 0)) {
      picture_ = TestPicture{std::string(size, char(*count_))};
    }
  }
  TimePoint time;
  std::optional<int> news;
  std::size_t picture = 0; // [bytes]

private:
  Production<int> count_{*this, "count"};
  Production<int> news_{*this, "news"};
  Production<TestPicture> picture_{*this, "picture"};
};

/// A robot with a client that reads at once and a client that reads on request, through a UNIX socket, whose buffer is
/// far smaller than a large image.
struct Scene {
  Scene() {
    fast.send(subscribe, "Brain.count");
    slow.send(subscribeBulk, R"({"keys": ["Brain.count", "Brain.news", "Brain.picture"]})");
    for (MateClient* client : {&fast, &slow}) {
      client->send(requestList);
      client->receive(list);
    }
  }
  static SocketSettings settings(const ConfiguredRobot& robot) {
    SocketSettings settings;
    settings.debugPort = settings.configPort = 0;
    settings.unixFolder = robot.folder.path() / "sockets";
    return settings;
  }
  void cycle() {
    brain.cycle();
    REQUIRE(fast.receiveJson(update).at(0)["value"] == ++cycles); // sent to all clients, at the latest before the next
                                                                  // cycle
  }
  /// Publishes an image that blocks the slow client.
  void block() {
    reporter.picture = large;
    cycle();
  }
  /// Reads the blocking image.
  void unblock() {
    CHECK(slow.receive().value().type == image);
    CHECK(values() == json{{"Brain.count", 1}});
  }
  /// Values of the next frame, which must be an update.
  json values() {
    json found;
    const auto frame = slow.receive();
    REQUIRE(frame);
    REQUIRE(frame->type == update);
    for (const json& entry : json::parse(frame->body)) {
      REQUIRE_FALSE(found.contains(entry["key"].get<std::string>()));
      found[entry["key"].get<std::string>()] = entry["value"];
      times[entry["key"].get<std::string>()] = entry["timestamp"];
    }
    return found;
  }
  /// Cycle of the image in the next frame.
  int pictureOf() {
    const auto frame = slow.receive();
    REQUIRE(frame);
    REQUIRE(frame->type == image);
    return frame->body.back();
  }

  static constexpr std::size_t large = 4 << 20;
  const TimePoint base = TimePoint{} + 5h;
  const ConfiguredRobot robot;
  Thread brain{"Brain", RobotPart::head};
  Reporter& reporter = brain.add<Reporter>(base);
  Database database{{&brain}};
  Configuration configuration{robot.folder.path(), robot.names, writeAtomically};
  SocketServers sockets{settings(robot), {&brain}, configuration, base, [](auto) {}};
  MateClient fast = MateClient::debug(sockets.debugPort());
  MateClient slow = MateClient::debug(robot.folder.path() / "sockets" / "debug");
  int cycles = 0;
  json times;
};

} // namespace

TEST_CASE("all keys are listed before their first value") {
  // Proves the list's format as MATE reads it, and that images are marked.
  ShownRobot robot;
  auto client = robot.debug();
  json keys;
  const json answer = listed(client);
  for (const json& entry : answer["keys"]) {
    keys[entry["key"].get<std::string>()] = entry;
  }
  CHECK(keys.size() == 6);
  CHECK(keys["Brain.count"] == json::parse(R"({"key": "Brain.count", "timestamp": 0, "value": null})"));
  CHECK(keys["Brain.picture"] == json::parse(R"({"key": "Brain.picture", "isImage": true})"));
  CHECK(keys.contains("Brain.Counter.scaled"));
  CHECK(keys.contains("Brain.measuredCycleTime"));
}

TEST_CASE("an update has the bytes of HULKs' protocol") {
  // Compares every byte of an update with a message assembled by hand from the protocol's description.
  ShownRobot robot;
  auto client = robot.debug();
  client.send(subscribe, "Brain.count");
  listed(client);
  robot.brain.cycle();
  const auto received = client.receive();
  REQUIRE(received);
  const std::string body = "[{\"key\":\"Brain.count\",\"timestamp\":12,\"value\":1}\n]";
  CHECK(received->type == update);
  CHECK(received->body == body);
  CHECK(client.frame(update, body) == std::string("DMSG\x01\x02\0\0\x31\0\0\0\0\0\0\0", 16) + body);
}

TEST_CASE("one update holds a cycle's keys, and pictures go before it") {
  // Proves order, format and timestamps, that only edited keys are sent, and a history's newest value.
  ShownRobot robot;
  auto client = robot.debug();
  client.send(subscribeBulk, R"({"keys": ["Brain.picture", "Brain.Counter.scaled", "Brain.history", "Brain.later"]})");
  listed(client);
  for (int cycle = 1; cycle <= 3; ++cycle) {
    robot.brain.cycle();
    if (cycle == 3) {
      const auto picture = client.receive();
      REQUIRE(picture);
      REQUIRE(picture->type == image);
      const std::string expected = std::string("\x24\0\0\0\0\0\0\0\x80\x02\xe0\x01\x0d\0", 14) + "Brain.picture" +
                                   std::string(100, '\x03'); // 36 ms, 640, 480, 13 characters
      CHECK(picture->body == expected);
    }
    const auto values = client.receive();
    REQUIRE(values);
    REQUIRE(values->type == update);
    CHECK(json::parse(values->body) ==
          json{{{"key", "Brain.Counter.scaled"}, {"timestamp", 12 * cycle}, {"value", {0.5 * cycle, nullptr}}},
               {{"key", "Brain.history"}, {"timestamp", 12 * cycle}, {"value", -cycle}}});
  }
}

TEST_CASE("nothing is copied that nobody subscribed to") {
  // Proves that subscribing, unsubscribing and disconnecting reach the production.
  ShownRobot robot;
  const AnyProduction* count = robot.database.find("Brain.count");
  CHECK_FALSE(count->isWanted());
  auto first = robot.debug();
  {
    auto second = robot.debug();
    first.send(subscribe, "Brain.count");
    second.send(subscribe, "Brain.count");
    listed(first);
    listed(second);
    first.send(unsubscribe, "Brain.count");
    listed(first);
    CHECK(count->isWanted());
  }
  for (int i = 0; i < 1000 && count->isWanted(); ++i) {
    listed(first); // until the server has noticed the second one's disconnection
  }
  CHECK_FALSE(count->isWanted());
}

TEST_CASE("a client that never reads neither blocks the cycle nor starves the others") {
  // Proves it with images of 1 MiB for a client that reads nothing and one that reads everything. The fast one gets
  // every cycle, since the test waits for it; the slow one gets fewer, but only whole frames.
  ShownRobot robot;
  robot.counter.pictureSize = 1 << 20;
  auto slow = robot.debug();
  auto fast = robot.debug();
  for (auto* client : {&slow, &fast}) {
    client->send(subscribeBulk, R"({"keys": ["Brain.picture", "Brain.count"]})");
    listed(*client);
  }
  const int cycles = 90;
  int pictures = 0;
  for (int cycle = 1; cycle <= cycles; ++cycle) {
    robot.brain.cycle();
    auto frame = fast.receive();
    REQUIRE(frame);
    if (frame->type == image) {
      ++pictures;
      frame = fast.receive();
    }
    REQUIRE(frame);
    REQUIRE(json::parse(frame->body).at(0)["value"] == cycle);
    listed(fast); // no frame is on its way any more
  }
  CHECK(pictures == cycles / 3);
  slow.send(requestList);
  int got = 0;
  for (auto frame = slow.receive(); frame && frame->type != list; frame = slow.receive()) {
    got += frame->type == image ? 1 : 0;
  }
  CHECK(got >= 1);
  CHECK(got < cycles / 3);
}

TEST_CASE("a thread whose pictures take long does not hold up the other thread's values") {
  // Proves that threads take turns: eight images are queued when the value arrives, and at most four are sent before
  // it.
  const ConfiguredRobot robot;
  std::promise<void> ready;
  Thread brain{"Brain", RobotPart::head}, motion{"Motion", RobotPart::body};
  brain.add<SlowCamera>(ready.get_future().share());
  const Database database{{&brain, &motion}};
  SocketSettings settings;
  settings.debugPort = settings.configPort = 0;
  Configuration configuration{robot.folder.path(), robot.names, writeAtomically};
  const SocketServers sockets{settings, {&brain, &motion}, configuration, TimePoint{}, [](auto) {}};
  auto client = MateClient::debug(sockets.debugPort());
  client.send(subscribeBulk, R"({"keys": ["Brain.slowPicture", "Motion.measuredCycleTime"]})");
  listed(client);
  for (int i = 0; i < 8; ++i) {
    brain.cycle();
  }
  motion.cycle();
  ready.set_value();
  int pictures = 0;
  for (auto frame = client.receive(); frame && frame->type == image; frame = client.receive()) {
    ++pictures;
  }
  CHECK(pictures <= 4);
}

TEST_CASE("a client that asks and never reads is closed") {
  // Proves the limit of the send queue, and the message. The rate limit is disabled.
  ShownRobot robot{{.messagesPerSecond = 1e9}};
  auto client = robot.debug();
  std::string requests;
  for (int i = 0; i < 1000; ++i) {
    requests += client.frame(requestList, "");
  }
  for (int i = 0; i < 1000 && !robot.hasLogged("does not read"); ++i) {
    client.sendBytes(requests);
  }
  CHECK(robot.isLogged("asks for answers and does not read them; the connection was closed."));
}

TEST_CASE("many clients over both kinds of sockets get the same") {
  // Proves it for eight clients, half of them on UNIX sockets.
  ShownRobot robot;
  std::vector<MateClient> clients;
  for (int i = 0; i < 4; ++i) {
    clients.push_back(robot.debug());
    clients.push_back(MateClient::debug(robot.settings.unixFolder / "debug"));
  }
  for (auto& client : clients) {
    client.send(subscribe, "Brain.count");
    listed(client);
  }
  for (int cycle = 1; cycle <= 20; ++cycle) {
    robot.brain.cycle();
    for (auto& client : clients) {
      REQUIRE(client.receiveJson(update).at(0)["value"] == cycle);
    }
  }
}

TEST_CASE("what changed once while a client was busy reaches it with the next cycle, in its newest state") {
  // Proves it for a value that is not published again: it is sent once, with the time of its own cycle.
  Scene scene;
  scene.block();
  for (const int value : {6, 7}) {
    scene.reporter.news = value;
    scene.cycle();
  }
  scene.cycle();
  scene.unblock();
  scene.cycle();
  CHECK(scene.values() == json{{"Brain.count", 5}, {"Brain.news", 7}});
  CHECK(scene.times == json{{"Brain.count", 60}, {"Brain.news", 36}});
  scene.cycle();
  CHECK(scene.values() == json{{"Brain.count", 6}});
}

TEST_CASE("what a busy client does not want any more is not sent to it") {
  // Proves that the queue is bounded by the subscriptions.
  Scene scene;
  scene.block();
  scene.reporter.news = 6;
  scene.cycle();
  scene.slow.send(unsubscribe, "Brain.news");
  scene.slow.send(requestList);
  scene.unblock();
  CHECK(scene.slow.receive(list));
  scene.cycle();
  CHECK(scene.values() == json{{"Brain.count", 3}});
}

TEST_CASE("values that a client missed go before the pictures of the cycle that finds it ready") {
  // Proves the order, and that a newer image replaces a queued one.
  Scene scene;
  scene.block();
  scene.reporter.news = 6;
  scene.reporter.picture = 100;
  scene.cycle();
  scene.unblock();
  scene.reporter.picture = 100;
  scene.cycle();
  CHECK(scene.values() == json{{"Brain.count", 3}, {"Brain.news", 6}});
  CHECK(scene.pictureOf() == 3);
  scene.cycle();
  CHECK(scene.values() == json{{"Brain.count", 4}});
}

TEST_CASE("a picture that is not renewed reaches a client that was busy when it was taken") {
  // Proves that the newest image is sent once, after one second of the robot's time; an image published earlier would
  // be sent with the values of its own cycle.
  Scene scene;
  scene.block();
  for (int i = 0; i < 2; ++i) {
    scene.reporter.picture = 100;
    scene.cycle();
  }
  scene.unblock();
  scene.cycle();
  CHECK(scene.values() == json{{"Brain.count", 4}});
  scene.reporter.time += 1s;
  scene.cycle();
  CHECK(scene.values() == json{{"Brain.count", 5}});
  CHECK(scene.pictureOf() == 3);
  scene.cycle();
  CHECK(scene.values() == json{{"Brain.count", 6}});
}

} // namespace naocal

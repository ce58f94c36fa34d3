#include "DebugNumbers.hpp"
#include "ShownRobot.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

/// Shows its cycles' count always, news and pictures when the test wants.
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

/// A robot with a client that reads at once and one that reads when the test says so: behind a UNIX socket, which
/// holds far less than a large picture.
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
    REQUIRE(fast.receiveJson(update).at(0)["value"] == ++cycles); // has gone to all clients, or will before the next
  }
  /// A picture that the slow client has not read yet.
  void block() {
    reporter.picture = large;
    cycle();
  }
  /// Reads what blocked it.
  void unblock() {
    CHECK(slow.receive().value().type == image);
    CHECK(values() == json{{"Brain.count", 1}});
  }
  /// Of the next frame, which is an update.
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
  /// The cycle of the picture in the next frame.
  int pictureOf() {
    const auto frame = slow.receive();
    REQUIRE(frame);
    REQUIRE(frame->type == image);
    return frame->body.back();
  }

  static constexpr std::size_t large = 4 << 20;
  const TimePoint base = TimePoint{} + 5h;
  const ConfiguredRobot robot;
  Thread brain{"Brain", Part::head};
  Reporter& reporter = brain.add<Reporter>(base);
  Database database{{&brain}};
  Configuration configuration{robot.folder.path(), robot.names, writeAtomically};
  Sockets sockets{settings(robot), {&brain}, configuration, base, [](auto) {}};
  MateClient fast = MateClient::debug(sockets.debugPort());
  MateClient slow = MateClient::debug(robot.folder.path() / "sockets" / "debug");
  int cycles = 0;
  json times;
};

} // namespace

TEST_CASE("what changed once while a client was busy reaches it with the next cycle, in its newest state") {
  // Proves it for a value that is produced in no later cycle, with the time of its own cycle, and once only.
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
  // Proves that what waits is bounded by what is subscribed to.
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
  // Proves the order, and that a newer picture replaces the one that waits.
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
  // Proves that the newest one comes, once, when a second of the robot's time has passed: until then one that is
  // renewed would come with its own cycle's values.
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

#include "framework/ConfiguredRobot.hpp"
#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/core/ModuleConfiguration.hpp"
#include "framework/core/Parameter.hpp"
#include "framework/core/Thread.hpp"

#include <catch2/catch.hpp>
#include <memory>

namespace naocal {
namespace {

std::string positive(const double& value) {
  return value > 0 ? "" : "a positive number";
}

class Player : public Module {
public:
  Player() : Module{"Player"} {}
  void cycle() override { seen.push_back(*speed_); }
  void onParametersChanged() override { ++changes; }

  std::vector<double> seen;
  int changes = 0;
  const std::vector<double>& gains() const { return *gains_; }

private:
  Parameter<double> speed_{*this, "speed", positive};
  Parameter<bool> careful_{*this, "careful"};
  Parameter<int> repeats_{*this, "repeats"};
  Parameter<std::string> name_{*this, "name"};
  Parameter<std::vector<double>> gains_{*this, "gains"};
};

const nlohmann::json good = {{"speed", 0.5}, {"careful", true}, {"repeats", 3}, {"name", "wave"}, {"gains", {1, 2, 3}}};

/// Warnings about the last configured file's keys.
std::vector<std::string>& unknownKeys() {
  static std::vector<std::string> unknown;
  return unknown;
}

struct Configured {
  explicit Configured(const nlohmann::json& content) {
    robot.file("default/body/default/Player.json", content.dump());
    unknownKeys() = configureModules(motion, robot.configuration);
  }
  ConfiguredRobot robot;
  Thread motion{"Motion", RobotPart::body};
  Player& player = motion.add<Player>();
};

std::string configurationError(const nlohmann::json& content) {
  try {
    Configured{content};
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "configured";
}

} // namespace

TEST_CASE("a module's parameters come from the file of its name") {
  // Proves mount name, file and values.
  Configured configured{good};
  CHECK(configured.player.gains() == std::vector<double>{1, 2, 3});
  CHECK(configured.player.changes == 1);
  CHECK(configured.robot.readKeys("Motion.Player") == good);
}

TEST_CASE("a change reaches a module between two cycles") {
  // Proves that changes take effect only at the next cycle, that the module is notified of each change, also of two
  // changes of one parameter, and that a refused value changes neither module nor configuration. Concurrent changes are
  // tested below.
  Configured configured{good};
  auto& [robot, motion, player] = configured;
  motion.cycle();
  robot.configuration.set("Motion.Player", "speed", 0.25);
  robot.configuration.set("Motion.Player", "speed", 0.75);
  robot.configuration.set("Motion.Player", "gains[1]", 7);
  CHECK(player.gains()[1] == 2);
  motion.cycle();
  motion.cycle();
  CHECK(player.gains()[1] == 7);
  CHECK(player.seen == std::vector<double>{0.5, 0.75, 0.75});
  CHECK(player.changes == 4);
  CHECK_THROWS_AS(robot.configuration.set("Motion.Player", "speed", -1), ConfigurationError);
  motion.cycle();
  CHECK(player.seen.back() == 0.75);
  CHECK(robot.readKeys("Motion.Player")["speed"] == 0.75);
}

TEST_CASE("changes from other threads arrive in their order while the cycle goes on") {
  // Proves that a module never sees an older value after a newer one and sees the last one; the thread sanitizer checks
  // for data races.
  Configured configured{good};
  auto& [robot, motion, player] = configured;
  std::thread editor{[&configuration = robot.configuration] {
    for (int i = 1; i <= 500; ++i) {
      configuration.set("Motion.Player", "speed", i);
    }
  }};
  for (int i = 0; i < 2000; ++i) {
    motion.cycle();
  }
  editor.join();
  for (std::size_t rest = 0; rest <= 500; rest += Thread::changesPerCycle) {
    motion.cycle();
  }
  const auto from = player.seen.begin() + 1;
  CHECK(std::is_sorted(from, player.seen.end()));
  CHECK(player.seen.back() == 500);
}

TEST_CASE("what clients allocated for a change is freed by clients") {
  // Proves that no cycle frees an applied change, whose memory may belong to a thread that has lost its processor.
  Configured configured{good};
  auto& [robot, motion, player] = configured;
  auto token = std::make_shared<int>(1);
  const std::weak_ptr<int> watched = token;
  motion.postChange(player, *player.parameters().front(), [token = std::move(token)] {});
  for (int i = 0; i < 3; ++i) {
    motion.cycle();
    CHECK_FALSE(watched.expired());
  }
  robot.configuration.set("Motion.Player", "speed", 0.25);
  CHECK(watched.expired());
}

TEST_CASE("however many changes arrive, a cycle applies a bounded number, and the newest value is not lost") {
  // Proves both numbers at their boundary: beyond those that wait, a parameter's newest value replaces its last one,
  // and another parameter's is kept.
  Configured configured{good};
  auto& [robot, motion, player] = configured;
  const int most = int(Thread::mostChanges), perCycle = int(Thread::changesPerCycle);
  const int before = player.changes;
  for (int i = 1; i <= most + 50; ++i) {
    robot.configuration.set("Motion.Player", "speed", i);
  }
  robot.configuration.set("Motion.Player", "gains[0]", 9);
  motion.cycle();
  CHECK(player.changes == before + perCycle);
  CHECK(player.seen.back() == perCycle);
  for (int cycle = 1; cycle < most / perCycle; ++cycle) {
    motion.cycle();
  }
  CHECK(player.changes == before + most);
  CHECK(player.seen.back() == most + 50);
  CHECK(player.gains()[0] == 1);
  motion.cycle();
  CHECK(player.changes == before + most + 1);
  CHECK(player.gains()[0] == 9);
}

TEST_CASE("configuration errors are sentences with names") {
  // Pins the messages: module, key, what was expected and found.
  const auto with = [](const char* key, const nlohmann::json& value) {
    auto content = good;
    content[key] = value;
    return configurationError(content);
  };
  auto missing = good;
  missing.erase("speed");
  CHECK(configurationError(missing) == "Motion.Player: the parameter speed is missing; add it to Player.json in a "
                                       "location of the configuration");
  CHECK(with("speed", "fast") == "Motion.Player: speed: expected a number, found \"fast\"");
  CHECK(with("speed", -2) == "Motion.Player: speed: expected a positive number, found -2");
  CHECK(with("careful", 1) == "Motion.Player: careful: expected true or false, found 1");
  CHECK(with("repeats", 2.5) ==
        "Motion.Player: repeats: expected a whole number from -2147483648 to 2147483647, found 2.5");
  CHECK(with("repeats", 1e12) ==
        "Motion.Player: repeats: expected a whole number from -2147483648 to 2147483647, found 1000000000000.0");
  CHECK(with("name", 3) == "Motion.Player: name: expected another value than 3: type must be string, but is number");
  CHECK(with("gains", {1, "two"}) == "Motion.Player: gains: expected another value than [1,\"two\"]: type must be "
                                     "number, but is string");
  CHECK(with("speed", nullptr) == "Motion.Player: speed: expected a number, found null");
  auto misspelt = good;
  misspelt["spede"] = 1;
  CHECK(configurationError(misspelt) == "configured");
  CHECK(unknownKeys() ==
        std::vector<std::string>{"Motion.Player: Player.json has a key \"spede\" that means nothing there; known are "
                                 "careful, gains, name, repeats, speed"});
  CHECK(configurationError(good) == "configured");
  CHECK(unknownKeys().empty());
}

TEST_CASE("what numbers are asked to be") {
  // Proves both limits of each check, and NaN.
  const double none = std::nan("");
  CHECK(checkWithin<0, 3>(3.0).empty());
  CHECK(checkWithin<0, 3>(0).empty());
  for (const double outside : {-0.1, 3.1, none}) {
    CHECK(checkWithin<0, 3>(outside) == "a number from 0 to 3");
    CHECK_FALSE(checkEachWithin<0, 3>({1, outside}).empty());
  }
  CHECK(checkEachWithin<0, 3>({1, 2}).empty());
  CHECK_FALSE(checkEachWithin<0, 3>({}).empty());
  CHECK_FALSE(checkEachWithin<0, 3>(std::vector<double>(21, 1)).empty());
  CHECK(checkShare(1).empty());
  for (const double outside : {0.0, 1.1, none}) {
    CHECK(checkShare(outside) == "a number above 0, at most 1");
  }
}

TEST_CASE("an order counts when it is given, whatever else changes") {
  // Proves that the file's value gives no command, that each SET gives one, also of an equal value, and that other
  // parameters give none.
  class Runner : public Module {
  public:
    Runner() : Module{"Runner"} {}
    void cycle() override {}
    void onParametersChanged() override { given += run_.takeCommand(); }
    int given = 0;

  private:
    CommandParameter<std::string> run_{*this, "run"};
    Parameter<int> repeats_{*this, "repeats"};
  };
  ConfiguredRobot robot;
  robot.file("default/body/default/Runner.json", R"({"run": "left", "repeats": 1})");
  Thread motion{"Motion", RobotPart::body};
  const Runner& runner = motion.add<Runner>();
  configureModules(motion, robot.configuration);
  motion.cycle();
  CHECK(runner.given == 0);
  robot.configuration.set("Motion.Runner", "repeats", 2);
  motion.cycle();
  CHECK(runner.given == 0);
  for (const char* order : {"right", "right", ""}) {
    robot.configuration.set("Motion.Runner", "run", order);
  }
  motion.cycle();
  CHECK(runner.given == 3);
}

} // namespace naocal

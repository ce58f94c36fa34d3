#include "ConfiguredRobot.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

namespace naocal {
namespace {

using nlohmann::json;

const std::string mountName = "Motion.Offsets";

/// Offsets that belong together: all keys equal.
json allEqual(int value) {
  json keys;
  for (int i = 0; i < 26; ++i) {
    keys[fmt::format("joint{}", i)] = value;
  }
  return keys;
}

/// Saves ever new values until it is killed, and undoes some of the saves.
[[noreturn]] void keepSaving(const std::filesystem::path& root, int first, int pipe) {
  Configuration configuration{root, {"", "Ada", "Bob"}, writeAtomically};
  configuration.mount(mountName, "Offsets.json", Part::body);
  for (int value = first;; ++value) {
    for (int i = 0; i < 26; ++i) {
      configuration.set(mountName, fmt::format("joint{}", i), value);
    }
    configuration.save();
    if (value % 3 == 0) {
      configuration.undo(mountName);
    }
    if (value == first && ::write(pipe, "r", 1) != 1) {
      ::_exit(1);
    }
  }
}

} // namespace

TEST_CASE("a configuration whose writer is killed at any moment is the old or the new one") {
  // Proves it for 200 kills at random moments of saving and undoing: every file of the robot is whole and holds values
  // that belong together. A power cut (what the disk had not yet written) is not simulated.
  ConfiguredRobot robot;
  robot.file("default/body/default/Offsets.json", allEqual(0).dump());
  std::mt19937 random{1};
  int last = 1;
  int saved = 0;
  for (int kill = 0; kill < 200; ++kill) {
    std::array<int, 2> pipe{};
    REQUIRE(::pipe(pipe.data()) == 0);
    const auto begin = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      keepSaving(robot.folder.path(), last, pipe[1]);
    }
    char started = 0;
    REQUIRE(::read(pipe[0], &started, 1) == 1);
    const auto oneSave = std::chrono::steady_clock::now() - begin;
    std::this_thread::sleep_for(oneSave * std::uniform_real_distribution<double>{0, 1.5}(random));
    ::kill(child, SIGKILL);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
    ::close(pipe[0]);
    ::close(pipe[1]);

    Configuration configuration{robot.folder.path(), robot.names, writeAtomically};
    configuration.mount(mountName, "Offsets.json", Part::body);
    json keys;
    configuration.keys(mountName, keys);
    const int value = keys["joint0"];
    REQUIRE(keys == allEqual(value));
    const bool isUndone = !std::filesystem::exists(robot.path("default/body/Bob/Offsets.json.previous"));
    const json previous = isUndone ? json::object() : robot.content("default/body/Bob/Offsets.json.previous");
    REQUIRE((previous.empty() || previous == allEqual(previous["joint0"])));
    saved += value > last ? 1 : 0;
    last = std::max(last, value) + 1;
  }
  CHECK(saved > 20); // else the writer was never in the middle of anything
}

} // namespace naocal

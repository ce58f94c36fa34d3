#include "PowerLoss.hpp"

#include "framework/ConfiguredRobot.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace naocal {
namespace {

using nlohmann::json;

/// Offsets and mounts of a robot, which belong together: both hold the same value.
struct SavedPair {
  explicit SavedPair(const std::filesystem::path& root)
      : configuration{root, {"Home", "Ada", "Bob"}, writeAtomically, [this](std::string_view line) { said = line; }} {
    configuration.mount("Offsets", "Offsets.json", RobotPart::body);
    configuration.mount("Mounts", "Mounts.json", RobotPart::head);
    configuration.saveTogether({"Offsets", "Mounts"});
  }
  void save(int value) {
    configuration.set("Offsets", "value", value);
    configuration.set("Mounts", "value", value);
    configuration.save();
  }
  int value(const char* mount) const {
    json keys;
    configuration.readKeys(mount, keys);
    return keys["value"];
  }
  std::string said;
  Configuration configuration;
};

/// A configuration with shipped values 0 in a temporary folder.
struct Shipped {
  Shipped() {
    robot.file("default/body/default/Offsets.json", R"({"value": 0})");
    robot.file("default/head/default/Mounts.json", R"({"value": 0})");
  }
  std::filesystem::path root() const { return robot.folder.path(); }
  ConfiguredRobot robot;
};

/// The values that a robot finds at its start, in all states after a number of requests; fails if the two differ.
std::set<int> valuesFound(const PowerLoss& failure, std::size_t requests) {
  std::set<int> values;
  for (const PowerLoss::State& state : failure.statesAfter(requests)) {
    const TemporaryFolder folder;
    PowerLoss::restore(state, folder.path());
    const SavedPair robot{folder.path()};
    CHECK(robot.said.empty());
    CHECK(robot.value("Offsets") == robot.value("Mounts"));
    values.insert(robot.value("Offsets"));
    CHECK_FALSE(std::filesystem::exists(folder.path() / "location/unfinished-save.json"));
  }
  return values;
}

} // namespace

TEST_CASE("after a power failure at any moment of a save, offsets and mounts are both old or both new") {
  // Proves it for a robot's first save, which makes its folders, for the next one, and for an undo, in all states of
  // the disk that POSIX allows. What has been saved is not lost by what follows.
  const Shipped shipped;
  std::optional<SavedPair> robot{shipped.root()};
  std::size_t saved = 0;
  const PowerLoss failure{shipped.root(), [&] {
                            robot->save(1);
                            saved = powerLoss::recording->requests.size();
                            robot->save(2);
                          }};
  for (std::size_t requests = 0; requests <= failure.requests(); ++requests) {
    CAPTURE(requests, failure.requests());
    const std::set<int> values = valuesFound(failure, requests);
    const std::set<int> allowed = requests < saved ? std::set{0, 1} : std::set{1, 2};
    CHECK(std::includes(allowed.begin(), allowed.end(), values.begin(), values.end()));
  }
  CHECK(valuesFound(failure, 0) == std::set{0});
  CHECK(valuesFound(failure, saved) == std::set{1});
  CHECK(valuesFound(failure, failure.requests()) == std::set{2});
  const PowerLoss undone{shipped.root(), [&] { robot->configuration.undo("Offsets"); }};
  for (std::size_t requests = 0; requests <= undone.requests(); ++requests) {
    CAPTURE(requests);
    const std::set<int> values = valuesFound(undone, requests);
    const std::set<int> allowed{1, 2};
    CHECK(std::includes(allowed.begin(), allowed.end(), values.begin(), values.end()));
  }
  CHECK(valuesFound(undone, undone.requests()) == std::set{1});
}

TEST_CASE("a journal does not come back after a power failure") {
  // Proves it where something else is saved into one of the files after a save: the save's journal would undo that.
  const Shipped shipped;
  SavedPair robot{shipped.root()};
  const PowerLoss failure{shipped.root(), [&] {
                            robot.save(1);
                            for (const char* file : {"default/body/Bob/Offsets.json", "default/head/Ada/Mounts.json"}) {
                              writeAtomically(shipped.robot.path(file), R"({"value": 5})");
                            }
                          }};
  CHECK(valuesFound(failure, failure.requests()) == std::set{5});
}

} // namespace naocal

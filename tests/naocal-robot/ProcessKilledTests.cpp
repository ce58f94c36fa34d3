#include "SimulatedProcess.hpp"

#include "data/CaptureSetFile.hpp"
#include "math/Angles.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <spawn.h>
#include <sys/wait.h>

namespace naocal {

using nlohmann::json;

namespace {

/// $NAOCAL_KILLS, or few enough for every day.
int killCount() {
  const char* wanted = std::getenv("NAOCAL_KILLS");
  return wanted ? std::atoi(wanted) : 6;
}

/// An object of the robot's own configuration; empty where the file is not there yet.
json saved(const std::filesystem::path& folder, const std::string& file) {
  const auto path = folder / "state/location" / file;
  return std::filesystem::exists(path) ? json::parse(readFile(path)) : json::object();
}

/// All recordings below a folder, by the pictures that lie in each.
std::map<std::filesystem::path, std::size_t> recordings(const std::filesystem::path& folder) {
  std::map<std::filesystem::path, std::size_t> pictures;
  if (std::filesystem::exists(folder)) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder}) {
      if (entry.path().filename() == "captures.json") {
        pictures[entry.path().parent_path()];
      }
    }
  }
  for (auto& [recording, count] : pictures) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator{recording}) {
      count += entry.path().extension() == ".png" || entry.path().extension() == ".pgm";
    }
  }
  return pictures;
}

} // namespace

// The victim of the case below, in a process of its own: calibrates and undoes until it is killed.
TEST_CASE("calibrates until it is killed", "[.victim]") {
  SimulatedProcess simulated{SimulatedProcess::plan(1, radians(1))};
  std::ofstream{std::getenv("NAOCAL_VICTIM")} << simulated.folder.path().string() << std::endl;
  for (int round = 0; round < 100; ++round) {
    simulated.calibrated(round % 3 == 2 ? "undo" : "head");
  }
}

// Proves that whatever moment a calibrating robot is killed at, offsets and mounts that are saved belong together, and
// recordings are readable up to their last capture. NAOCAL_KILLS=200 makes it two hundred.
TEST_CASE("a robot that is killed while it calibrates has its old or its new configuration, and its recordings",
          "[robot]") {
  std::mt19937 random{1}; // and chance enough in the scheduler
  int calibrated = 0, captures = 0;
  for (int kill = 0; kill < killCount(); ++kill) {
    const TemporaryFolder told;
    const std::string tell = told.path() / "folder";
    REQUIRE(setenv("NAOCAL_VICTIM", tell.c_str(), 1) == 0);
    std::string program = "/proc/self/exe", name = "calibrates until it is killed";
    char* const arguments[]{program.data(), name.data(), nullptr};
    pid_t victim = 0;
    REQUIRE(posix_spawn(&victim, program.c_str(), nullptr, nullptr, arguments, environ) == 0);
    std::string folder;
    for (int i = 0; i < 4000 && folder.empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds{5});
      std::ifstream{tell} >> folder;
    }
    REQUIRE_FALSE(folder.empty());
    std::this_thread::sleep_for(std::chrono::milliseconds{random() % 8000});
    ::kill(victim, SIGKILL);
    waitpid(victim, nullptr, 0);

    INFO("killed for the " << kill + 1 << ". time");
    { // as the next start does, which finishes what was cut off
      const std::filesystem::path root{folder};
      Configuration configuration{{root / "configuration", root / "state"}, {}, writeAtomically};
    }
    const json offsets = saved(folder, "default/body/synthetic-1/JointCalibrationProvider.json");
    const json mounts = saved(folder, "simulated/head/synthetic-1/Projection.json");
    CHECK(offsets.empty() == mounts.empty());
    CHECK(
        (mounts.empty() || (mounts.size() == 2 && mounts["top_ext"].size() == 3 && mounts["bottom_ext"].size() == 3)));
    CHECK((offsets.empty() || std::abs(offsets.at("headPitch").get<double>()) < 5));
    calibrated += offsets.empty() ? 0 : 1;
    for (const auto& [recording, pictures] : recordings(std::filesystem::path{folder} / "recordings")) {
      const CaptureSet set = readCaptureSet(recording).set;
      CHECK(set.captures.size() <= pictures);
      CHECK(set.captures.size() + 1 >= pictures); // the last picture's capture may not be noted yet
      captures += int(set.captures.size());
    }
    std::filesystem::remove_all(folder);
  }
  CHECK(captures > 0);
  CHECK((calibrated > 0 || killCount() < 20));
}

} // namespace naocal

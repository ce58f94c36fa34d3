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

/// Number of kills: $NAOCAL_KILLS, or 6 by default.
int killCount() {
  const char* wanted = std::getenv("NAOCAL_KILLS");
  return wanted ? std::atoi(wanted) : 6;
}

/// A file of the robot's own configuration; empty if missing.
json saved(const std::filesystem::path& folder, const std::string& file) {
  const auto path = folder / "state/location" / file;
  return std::filesystem::exists(path) ? json::parse(readFile(path)) : json::object();
}

/// All recordings below a folder, with the number of their pictures.
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

// Child process of the next test: calibrates and undoes until it is killed.
TEST_CASE("calibrates until it is killed", "[.victim]") {
  SimulatedProcess simulated{SimulatedProcess::plan(1, radians(1))};
  std::ofstream{std::getenv("NAOCAL_VICTIM")} << simulated.folder.path().string() << std::endl;
  for (int round = 0; round < 100; ++round) {
    simulated.calibrated(round % 3 == 2 ? "undo" : "head");
  }
}

// Proves that after SIGKILL at random moments of a calibration, saved offsets and mounts belong together, and
// recordings are readable up to the last capture. NAOCAL_KILLS=200 runs 200 kills; that one of them follows a complete
// calibration is only required from 20 kills on.
TEST_CASE("a robot that is killed while it calibrates has its old or its new configuration, and its recordings",
          "[robot]") {
  std::mt19937 random{1}; // delays are also random through the scheduler
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
    { // the next start completes an interrupted save
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
      CHECK(set.captures.size() + 1 >= pictures); // the last picture's capture may not be written yet
      captures += int(set.captures.size());
    }
    std::filesystem::remove_all(folder);
  }
  CHECK(captures > 0);
  if (killCount() >= 20) { // fewer may all come before a calibration's end
    CHECK(calibrated > 0);
  }
}

} // namespace naocal

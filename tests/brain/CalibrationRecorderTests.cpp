#include "brain/CalibrationRecorder.hpp"

#include "RobotV6.hpp"
#include "TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/GreyImage.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>

using namespace naocal;

namespace {

struct Grey : ImageBytes {
  explicit Grey(std::uint8_t grey) : all(64 * 48, grey) {}
  std::span<const std::uint8_t> bytes() const override { return all; }
  std::vector<std::uint8_t> all;
};

CaptureSet header() {
  CaptureSet set;
  set.bodyId = set.headId = "somebody";
  set.jointNames = {"HeadYaw", "HeadPitch"};
  set.cameras["top"] = {64, 48, 60, 60, 31.5, 23.5, {}};
  set.stances = {{0, SupportFoot::both, std::nullopt}};
  return set;
}

/// Number of kills: $NAOCAL_KILLS, or 8 by default.
int killCount() {
  const char* wanted = std::getenv("NAOCAL_KILLS");
  return wanted ? std::atoi(wanted) : 8;
}

} // namespace

// Child process of the next test: records until it is killed.
TEST_CASE("records until it is killed", "[.victim]") {
  CalibrationRecorder session{v6(), header(), std::getenv("NAOCAL_RECORDING"), {}};
  std::ofstream progress{std::string{std::getenv("NAOCAL_RECORDING")} + ".progress"};
  for (int i = 0; i < 100'000; ++i) {
    Capture capture;
    capture.pose = "P";
    capture.repeat = i;
    capture.time = Seconds{double(i)};
    capture.camera = "top";
    capture.supportFoot = SupportFoot::both;
    capture.joints.measured = {0.001 * i, 0.002 * i};
    const CameraFrame frame{CameraName::top,
                            PixelFormat::grey,
                            64,
                            48,
                            {},
                            std::uint64_t(i),
                            std::make_shared<Grey>(std::uint8_t(i % 250))};
    session.record(capture, frame);
    progress << i << std::endl; // written only after record() has returned
  }
}

// Proves that after SIGKILL at random moments all captures that record() confirmed are readable and complete. A power
// cut could lose more: files and directories are synchronised, but only a power cut would test that. NAOCAL_KILLS=200
// runs 200 kills.
TEST_CASE("a recording that is killed at any moment is readable up to its last capture", "[slow]") {
  std::mt19937 random{1}; // delays are also random through the scheduler
  int begun = 0;
  for (int kill = 0; kill < killCount(); ++kill) {
    const TemporaryFolder folder;
    const std::string session = folder.path() / "session";
    REQUIRE(setenv("NAOCAL_RECORDING", session.c_str(), 1) == 0);
    std::string program = "/proc/self/exe", name = "records until it is killed";
    char* const arguments[]{program.data(), name.data(), nullptr};
    pid_t victim = 0;
    REQUIRE(posix_spawn(&victim, program.c_str(), nullptr, nullptr, arguments, environ) == 0);
    for (int i = 0; i < 2000 && !std::filesystem::exists(session + ".progress"); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
    std::this_thread::sleep_for(std::chrono::microseconds{random() % 200'000});
    ::kill(victim, SIGKILL);
    waitpid(victim, nullptr, 0);

    int said = -1;
    std::ifstream progress{session + ".progress"};
    for (int number; progress >> number;) {
      said = progress.eof() ? said : number; // ignores a truncated last line
    }
    if (!std::filesystem::exists(session + "/captures.json")) {
      CHECK(said == -1);
      continue;
    }
    ++begun;
    const CaptureSet set = readCaptureSet(session).set;
    CHECK(int(set.captures.size()) >= said + 1);
    CHECK(int(set.captures.size()) <= said + 2);
    for (const Capture& capture : set.captures) {
      CHECK(capture.joints.measured == std::vector{0.001 * capture.id, 0.002 * capture.id});
      CHECK(readImage(std::filesystem::path{session} / capture.image).grey(10, 10) == capture.id % 250);
    }
  }
  CHECK(begun > 0);
}

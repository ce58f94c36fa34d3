#include "hardware/replay/ReplayWorld.hpp"

#include "RobotV6.hpp"
#include "TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "hardware/replay/ReplayTimeline.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "simulation/Renderer.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <thread>

using namespace naocal;
using namespace std::chrono_literals;

namespace {

/// A recorded set; all pixels of an image have the value 10 + capture id.
CaptureSet recorded(const std::filesystem::path& folder) {
  SimulationPlan plan;
  plan.images = true;
  plan.samples = 2;
  plan.cameras = nominalCameras(64, 48);
  plan.poses = planStandingPoses(v6(), SimulationPlan{}, SupportFoot::left, 3, 1);
  CaptureSet set = simulate(v6(), plan, 1).set;
  for (Capture& capture : set.captures) {
    capture.time = Seconds{std::round(1e9 * capture.time.count()) / 1e9}; // whole nanoseconds, as from a clock
  }
  std::filesystem::create_directories(folder / "images");
  for (const Capture& capture : set.captures) {
    writeImage({64, 48, std::vector<std::uint8_t>(64 * 48, std::uint8_t(10 + capture.id))}, folder / capture.image);
  }
  writeCaptureSet(set, folder);
  return readCaptureSet(folder).set;
}

struct Played {
  std::map<TimePoint, RobotState> states;
  std::vector<CameraFrame> frames;
};

Played played(ReplayWorld& world) {
  Played result;
  const auto robot = world.robot();
  const auto cameras = world.cameras();
  std::thread motion{[&] {
    while (!robot->hasEnded()) {
      if (const auto state = robot->waitForState(1s)) {
        result.states[state->time] = *state;
        robot->send({});
      }
    }
  }};
  while (!cameras->hasEnded()) {
    if (const auto frame = cameras->waitForFrame(100ms)) {
      result.frames.push_back(*frame);
    }
  }
  motion.join();
  return result;
}

} // namespace

// Proves that pairing images and joints reproduces exactly the recorded readings, image and time of every capture.
TEST_CASE("a replayed picture meets exactly the readings that were recorded with it") {
  const TemporaryFolder folder;
  const CaptureSet set = recorded(folder.path() / "session");
  ReplayWorld world{folder.path() / "session"};
  CHECK(world.robot()->waitForIdentity(0ms)->bodyId == set.bodyId);
  const Played result = played(world);
  CHECK(result.frames.size() == set.captures.size());
  for (const CameraFrame& frame : result.frames) {
    const Capture* capture = world.captureOf(frame);
    REQUIRE(capture);
    const TimePoint middle = frame.time + 17ms;
    const auto state = result.states.find(middle);
    REQUIRE(state != result.states.end());
    for (std::size_t i = 0; i < set.jointNames.size(); ++i) {
      const std::size_t joint = *jointIndex(set.jointNames[i]);
      CHECK(state->second.angles[joint] == capture->joints.measured[i]);
      CHECK(state->second.temperature[joint] == capture->joints.temperature[i]);
      CHECK(state->second.current[joint] == capture->joints.current[i]);
    }
    CHECK(state->second.torsoAngles == *capture->imu);
    CHECK(state->second.forces == *capture->fsr);
    CHECK(toGreyImage(frame)->grey(5, 7) == 10 + capture->id);
    CHECK(toString(frame.camera) == capture->camera);
    CHECK(toSeconds(middle.time_since_epoch()) == capture->time.count());
    CHECK(std::next(state) != result.states.end()); // the time is inside the recorded span
  }
}

// Proves that states are at most 24 ms apart, and that replays are reproducible.
TEST_CASE("a replayed robot reports every twelve milliseconds at the latest, and the same every time") {
  const TemporaryFolder folder;
  recorded(folder.path() / "session");
  ReplayWorld world{folder.path() / "session"}, again{folder.path() / "session"};
  const Played one = played(world), other = played(again);
  REQUIRE(one.states.size() > 100);
  for (auto state = std::next(one.states.begin()); state != one.states.end(); ++state) {
    CHECK(state->first - std::prev(state)->first <= 24ms);
  }
  CHECK(one.states.size() == other.states.size());
  CHECK(std::equal(one.states.begin(), one.states.end(), other.states.begin(), [](const auto& a, const auto& b) {
    return a.first == b.first && a.second.angles == b.second.angles;
  }));
  CHECK(
      std::equal(one.frames.begin(), one.frames.end(), other.frames.begin(), other.frames.end(),
                 [](const CameraFrame& a, const CameraFrame& b) { return a.time == b.time && a.camera == b.camera; }));
}

// Proves that a set that cannot be replayed is refused at construction.
TEST_CASE("captures that are days apart are replayed without the days between") {
  // Proves that the states' number does not grow with the gap, that each picture still meets its own readings, and that
  // a time that no clock of a robot shows is refused.
  const TemporaryFolder folder;
  CaptureSet set = recorded(folder.path());
  const ReplayTimeline before = buildTimeline(set, folder.path(), 0ns);
  for (Capture& capture : set.captures) {
    capture.time += capture.time > set.captures.front().time ? Seconds{30 * 86400.} : Seconds{0};
  }
  const ReplayTimeline apart = buildTimeline(set, folder.path(), 0ns);
  CHECK(apart.moments.size() < before.moments.size() + 2 * 60 * 1000 / 12 + 2);
  for (const ReplayTimeline::Picture& picture : apart.pictures) {
    CHECK(std::any_of(apart.moments.begin(), apart.moments.end(), [&](const ReplayTimeline::Moment& moment) {
      return moment.time == picture.frame.time &&
             set.captures[moment.capture].joints.measured == set.captures[picture.capture].joints.measured;
    }));
  }
  set.captures.back().time = Seconds{1e11};
  CHECK_THROWS_WITH(buildTimeline(set, folder.path(), 0ns),
                    Catch::EndsWith(": expected a time from -4e9 to 4e9 seconds, found 1e+11"));
}

TEST_CASE("a set without pictures, or whose pictures are gone, cannot be replayed") {
  const TemporaryFolder folder;
  CaptureSet set = recorded(folder.path() / "session");
  std::filesystem::remove(folder.path() / "session" / set.captures[3].image);
  CHECK_THROWS_AS(ReplayWorld{folder.path() / "session"}, InputError);
  CHECK_THROWS_AS(ReplayWorld{folder.path() / "nothing"}, InputError);
  set.captures.clear();
  writeCaptureSet(set, folder.path() / "empty");
  CHECK_THROWS_AS(ReplayWorld{folder.path() / "empty"}, InputError);
}

// Proves that an image of another size than its camera's gives no frame content.
TEST_CASE("a replayed picture that was exchanged for one of another size is absent") {
  const TemporaryFolder folder;
  const CaptureSet set = recorded(folder.path() / "session");
  ReplayWorld world{folder.path() / "session"};
  writeImage({32, 24, std::vector<std::uint8_t>(32 * 24)}, folder.path() / "session" / set.captures[0].image);
  std::size_t absent = 0;
  for (const CameraFrame& frame : played(world).frames) {
    absent += !toGreyImage(frame);
  }
  CHECK(absent == 1);
}

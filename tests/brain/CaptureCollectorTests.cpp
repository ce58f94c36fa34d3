#include "TemporaryFolder.hpp"
#include "brain/CaptureCollector.hpp"
#include "brain/ImageReader.hpp"
#include "brain/Projection.hpp"
#include "framework/configuration/Configuration.hpp"
#include "framework/core/Database.hpp"
#include "framework/core/ModuleConfiguration.hpp"
#include "framework/core/Thread.hpp"
#include "io/Files.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

namespace naocal {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr std::size_t yaw = *jointIndex("HeadYaw");

/// Cameras that return the test's pictures.
class GivenCameras final : public CameraInterface {
public:
  std::optional<CameraFrame> waitForFrame(milliseconds) override {
    if (frames.empty()) {
      return std::nullopt;
    }
    CameraFrame frame = frames.front();
    frames.pop_front();
    return frame;
  }
  CameraStatus status(CameraName) const override { return {}; }

  std::deque<CameraFrame> frames;
};

/// Known head angle over time; maximum speed 1 rad/s.
double trueYaw(TimePoint time) {
  return 0.5 * std::sin(2 * toSeconds(time.time_since_epoch()));
}

/// Stands in for the motion thread: pushes joint samples up to a time.
class Measuring : public Module {
public:
  Measuring() : Module{"Measuring"} {}
  void cycle() override {}
  void until(TimePoint now, std::mt19937& random) {
    for (; next_ <= now;
         next_ += milliseconds{12} + microseconds{std::uniform_int_distribution<int>{-900, 900}(random)}) {
      JointSample moment;
      moment.raw[yaw] = trueYaw(next_);
      moment.stillFor = still;
      moments_.edit().push(next_, moment);
    }
  }
  double still = 1;

private:
  TimePoint next_{std::chrono::seconds{1}};
  Production<JointSampleHistory> moments_{*this, "jointHistory"};
};

class Looking : public Module {
public:
  Looking() : Module{"Looking"} {}
  void cycle() override {}
  Dependency<StillImage> picture{*this, "stillPicture"};
};

struct Rig {
  explicit Rig(double latency) {
    std::filesystem::create_directories(folder.path() / "location/default");
    writeAtomically(folder.path() / "location/default/CaptureCollector.json",
                    nlohmann::json{{"latency", latency}}.dump());
    writeAtomically(folder.path() / "location/default/ImageReader.json",
                    R"({"topSettings": {}, "bottomSettings": {}})");
    brain.add<ImageReader>(cameras);
    brain.add<CaptureCollector>();
    database.emplace(std::vector<Thread*>{&motion, &brain});
    configureModules(brain, configuration);
  }
  TemporaryFolder folder;
  Configuration configuration{folder.path(), {"", "Ada", "Bob"}, writeAtomically};
  GivenCameras cameras;
  Thread motion{"Motion", RobotPart::body}, brain{"Brain", RobotPart::head};
  Measuring& measuring = motion.add<Measuring>();
  Looking& see = brain.add<Looking>();
  std::optional<Database> database;
};

CameraFrame frameAt(TimePoint time) {
  CameraFrame frame;
  frame.time = time;
  return frame;
}

/// Chessboard of 40-pixel squares, moved by `shift` pixels, with noise of 3 grey levels; rows 100 to 200 are brighter
/// by `flicker`.
GreyPicture picture(double shift, unsigned seed, int flicker = 0) {
  std::mt19937 random{seed};
  std::normal_distribution<double> noise{0, 3};
  GreyPicture result{640, 480, {}};
  for (int v = 0; v < result.height; ++v) {
    for (int u = 0; u < result.width; ++u) {
      const double wave = std::sin((u + shift) * 0.0785) * std::sin(v * 0.0785);
      const double grey = 128 + (wave > 0 ? 80 : -80) * std::min(1.0, 8 * std::abs(wave));
      const double light = v >= 100 && v < 200 ? flicker : 0;
      result.pixels.push_back(static_cast<std::uint8_t>(std::clamp(grey + light + noise(random), 0.0, 255.0)));
    }
  }
  return result;
}

} // namespace

TEST_CASE("a picture is paired with the joints in the middle of its exposure") {
  // Proves a pairing error below 1 ms of joint motion, for two cameras of 33 ms period, joint samples of 12 ms with
  // jitter, lost pictures, and pictures that arrive before or after the joint samples of their time.
  Rig rig{0.017};
  std::mt19937 random{1};
  TimePoint stamp{std::chrono::seconds{2}};
  int paired = 0;
  double worst = 0;
  for (int i = 0; i < 600; ++i) {
    stamp += microseconds{16667 + std::uniform_int_distribution<int>{-2000, 2000}(random)};
    if (i % 7 != 0) {
      rig.cameras.frames.push_back(frameAt(stamp));
    }
    rig.measuring.until(stamp + milliseconds{std::uniform_int_distribution<int>{5, 60}(random)}, random);
    rig.brain.cycle();
    if (rig.see.picture->isNew) {
      const StillImage& picture = *rig.see.picture;
      const TimePoint middle = picture.frame.time + milliseconds{17};
      worst = std::max(worst, std::abs(picture.capture.joints.measured[yaw] - trueYaw(middle)));
      ++paired;
    }
  }
  CHECK(worst < 1e-3); // [rad], equal to [s] at 1 rad/s
  CHECK(paired > 450);
}

TEST_CASE("pictures that were taken while something moved are not passed on") {
  // Proves that pictures taken during motion, and pictures without joint samples at their time, are dropped.
  Rig rig{0.017};
  std::mt19937 random{1};
  rig.measuring.still = 0;
  rig.measuring.until(TimePoint{std::chrono::seconds{3}}, random);
  rig.cameras.frames = {frameAt(TimePoint{milliseconds{2900}}), frameAt(TimePoint{milliseconds{900}})};
  rig.brain.cycle();
  CHECK_FALSE(rig.see.picture->isNew);
  rig.measuring.still = 1;
  rig.measuring.until(TimePoint{std::chrono::seconds{4}}, random);
  rig.brain.cycle();
  CHECK_FALSE(rig.see.picture->isNew);
  rig.cameras.frames = {frameAt(TimePoint{milliseconds{3900}})};
  rig.brain.cycle();
  REQUIRE(rig.see.picture->isNew);
  CHECK(rig.see.picture->capture.joints.measured.size() == jointCount);
  rig.brain.cycle();
  CHECK_FALSE(rig.see.picture->isNew);
}

TEST_CASE("two pictures never have the same timestamp in milliseconds") {
  // Proves unique timestamps, by which the panel pairs pictures and values, for two cameras that expose simultaneously.
  Rig rig{0.017};
  struct Times : CycleListener {
    void onCycleEnd(TimePoint time, const std::vector<AnyProduction*>&) override {
      stamps.push_back(std::chrono::duration_cast<milliseconds>(time.time_since_epoch()).count());
    }
    std::vector<long> stamps;
  } times;
  rig.brain.setListener(times);
  for (int i = 0; i < 5; ++i) {
    rig.cameras.frames = {frameAt(TimePoint{milliseconds{5000 + 33 * i}}),
                          frameAt(TimePoint{milliseconds{5000 + 33 * i}})};
    rig.brain.cycle();
    rig.brain.cycle();
  }
  REQUIRE(times.stamps.size() == 10);
  CHECK(std::adjacent_find(times.stamps.begin(), times.stamps.end(), std::greater_equal<>{}) == times.stamps.end());
}

TEST_CASE("pictures differ when half a pixel has moved, not by noise or flicker") {
  // Proves the separation at the limit shipped in CalibrationRunner.json, 2 grey levels.
  CHECK(imageDifference(picture(0, 1), picture(0, 2)) < 1);
  CHECK(imageDifference(picture(0, 1), picture(0, 2, 10)) < 1.5);
  CHECK(imageDifference(picture(0, 1), picture(0.5, 2)) > 2);
  CHECK(std::isinf(imageDifference(picture(0, 1), GreyPicture{320, 240, std::vector<std::uint8_t>(320 * 240)})));
}

} // namespace naocal

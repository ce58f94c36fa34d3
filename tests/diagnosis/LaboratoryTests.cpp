#include "diagnosis/Diagnosis.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/Residuals.hpp"
#include "setups/SetUpTwins.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

/// What arms before a tracker or a board suffer from in laboratories.
namespace naocal {
namespace {

Diagnosis diagnosed(const Recording& recording) {
  return diagnose(buildMeasurements(recording.sets, recording.robot));
}

/// One marker on the hand before a tracker. `sigma`: what the file says of its noise, such as `"sigma": 0.0003, `.
Recording markerBeforeTracker(const TemporaryFolder& folder, std::uint64_t seed, const std::string& sigma) {
  return makeArmTwin(folder, "marker",
                     R"("trackers": {"vicon": {)" + sigma + R"("about": {"x": 2, "y": 0.3, "z": 1, "yaw": 3}}},
                        "markers": [{"id": "m", "link": "hand", "about": [0.1, 0.05, 0.02]}])",
                     {.seed = seed, .poses = 40})
      .right;
}

/// Moves what the tracker reads of one capture after another along an axis [m].
void creep(Recording& recording, Eigen::Index axis, const std::function<double(double)>& shift) {
  std::vector<Capture>& captures = recording.sets.front().captures;
  for (std::size_t i = 0; i < captures.size(); ++i) {
    for (PointReading& reading : captures[i].points) {
      reading.xyz[axis] += shift(static_cast<double>(i));
    }
  }
}

} // namespace

TEST_CASE("what changes over time, but not steadily, is unknown, and not what explains less", "[slow]") {
  // Proves that an effect over time with evidence, which fails to predict the last captures, is not passed over for the
  // next best: a joint's zero creeps away and comes back.
  const TemporaryFolder folder;
  Recording creeping = markerBeforeTracker(folder, 3, R"("sigma": 0.0003, )");
  CaptureSet& set = creeping.sets.front();
  constexpr double turn = 30;
  for (std::size_t i = 0; i < set.captures.size(); ++i) {
    const auto at = static_cast<double>(i);
    spoiling::reading(set, set.captures[i], "lift") += radians(0.2) * (at < turn ? at / turn : 3 - 2 * at / turn);
  }
  const Diagnosis diagnosis = diagnosed(creeping);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::unknownEffect);
  CHECK(diagnosis.sentence.find("It sits at lift and varies with t (time)") != std::string::npos);
}

TEST_CASE("a tracker that creeps is named, and its creep is no noise", "[slow]") {
  // Proves that 4 mm in all do not end in the level of readings whose noise nobody tells.
  const TemporaryFolder folder;
  Recording creeping = markerBeforeTracker(folder, 2, "");
  creep(creeping, 0, [](double capture) { return 0.004 * capture / 40; });
  const Diagnosis diagnosis = diagnosed(creeping);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.suggested == std::vector<std::string>{"trackerDrift@vicon"});
  CHECK(diagnosis.lastFit.noise.readings.front() < 0.0006);
}

TEST_CASE("a tracker that creeps and comes back has no name, and the sentence says so", "[slow]") {
  // Proves that an effect that fails to predict the last captures is not called too weak, however large its evidence.
  const TemporaryFolder folder;
  Recording creeping = markerBeforeTracker(folder, 2, R"("sigma": 0.0003, )");
  creep(creeping, 2, [](double capture) { return 0.004 * (capture < 30 ? capture / 30 : 3 - capture / 15); });
  const Diagnosis diagnosis = diagnosed(creeping);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.suggested.empty());
  CHECK(diagnosis.sentence.find("too weak") == std::string::npos);
  CHECK((diagnosis.sentence.find("time") != std::string::npos ||
         diagnosis.sentence.find("vicon moved") != std::string::npos));
}

TEST_CASE("beside a likelier curve only what the captures need is named", "[slow]") {
  // Proves that effects which explain something beside a curve, which has no name, are not named in its place: a gain
  // of 1 % of the lift with a small bend is no tilt of the last axis.
  const TemporaryFolder folder;
  Recording bent = armBeforeTracker(folder, 1).right;
  CaptureSet& set = bent.sets.front();
  for (Capture& capture : set.captures) {
    double& lift = spoiling::reading(set, capture, "lift");
    lift += 0.01 * lift + 0.004 * std::sin(3 * lift);
  }
  const Diagnosis diagnosis = diagnosed(bent);
  CAPTURE(diagnosis.sentence);
  REQUIRE(!diagnosis.suggested.empty());
  for (const std::string& label : diagnosis.suggested) {
    CHECK(label.ends_with("@lift"));
  }
}

TEST_CASE("an effect that is certain, but too small to matter, has its picture", "[slow]") {
  // Proves that the sentence and the picture are of the same effect, and that adding it is not suggested.
  const TemporaryFolder folder;
  Recording coupled = makeArmTwin(folder, "many", R"(
    "trackers": {"laser": {"sigma": 0.0003, "about": {"x": 2, "y": 0.3, "z": 1, "yaw": 3}}},
    "frames": [{"id": "tool", "link": "hand", "about": {"x": 0.1, "yaw": 0.5, "roll": 0.4}}])",
                                  {.seed = 6, .poses = 150})
                          .right;
  CaptureSet& set = coupled.sets.front();
  for (Capture& capture : set.captures) {
    spoiling::reading(set, capture, "elbow") += 0.0003 * spoiling::reading(set, capture, "lift");
  }
  const Diagnosis diagnosis = diagnosed(coupled);
  CAPTURE(diagnosis.sentence);
  REQUIRE(diagnosis.verdict == Verdict::adequate);
  CHECK(diagnosis.suggested.empty());
  REQUIRE(diagnosis.figures.causes.size() == 1);
  CHECK(diagnosis.sentence.find(diagnosis.figures.causes.front().label + " is hardly chance") != std::string::npos);
  CHECK(diagnosis.figures.causes.front().after() < diagnosis.figures.causes.front().before());
}

TEST_CASE("corners without noise are diagnosed", "[slow]") {
  // Proves that corners from a simulation without noise, which are as exact as their digits, have an answer.
  const TemporaryFolder folder;
  const Recording noisy = armWithCamera(folder, 3).right;
  Recording exact = noisy;
  const Measurements measurements = buildMeasurements(noisy.sets, noisy.robot);
  const Model model = buildModel(measurements);
  const Residuals residuals{measurements, model, Noise{}};
  const auto state = residuals.startState(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount())));
  for (const BoardResidual& one : residuals.boardResiduals(state)) {
    const ImageObservation& picture = measurements.pictures[one.picture];
    std::vector<Eigen::Vector2d>& corners = exact.sets.front().captures[picture.capture].corners->front().uv;
    REQUIRE(static_cast<std::size_t>(one.predicted.cols()) == corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i] = one.predicted.col(static_cast<Eigen::Index>(i));
    }
  }
  const Diagnosis diagnosis = diagnosed(exact);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::adequate);
}

} // namespace naocal

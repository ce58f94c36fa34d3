#include "MeasuredArm.hpp"
#include "RobotV6.hpp"
#include "TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "estimation/CandidateTerms.hpp"
#include "measurements/Measurements.hpp"
#include "robot/RobotOfSet.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {
namespace {

constexpr std::size_t lift = 1; // joint of the arm, and its place in the captures' lists

/// An arm in 30 poses, whose captures record no directions.
CaptureSet unrecordedArm() {
  const TemporaryFolder folder;
  writeArmSet(folder.path() / "set", {.frames = false, .contacts = false});
  CaptureSet set = readCaptureSet(folder.path() / "set").set;
  set.folder.clear();
  return set;
}

Measurements built(const CaptureSet& set) {
  return buildMeasurements({set}, parseUrdf(measuredArmUrdf, "arm.urdf"));
}

/// Directions of "lift" by the captures' ids.
std::vector<double> directions(const Measurements& measurements) {
  std::vector<double> result(measurements.pictures.size());
  for (const ImageObservation& picture : measurements.pictures) {
    result[static_cast<std::size_t>(measurements.captureOf(picture).id)] = picture.instant.approach[lift];
  }
  return result;
}

std::optional<std::string> whyUntestable(const Measurements& measurements) {
  return untestableReason(hysteresis(), lift, measurements);
}

double& angleOf(Capture& capture) {
  return capture.joints.measured[lift];
}

} // namespace

TEST_CASE("directions of approach follow from the order of captures in time") {
  // Proves the signs of a joint's changes, the unknown first one, that hysteresis can be tested then, and that the
  // order of the file counts only at equal times.
  CaptureSet set = unrecordedArm();
  std::vector<double> expected{0};
  for (std::size_t i = 1; i < set.captures.size(); ++i) {
    expected.push_back(angleOf(set.captures[i]) > angleOf(set.captures[i - 1]) ? 1 : -1);
  }
  const Measurements measurements = built(set);
  CHECK(directions(measurements) == expected);
  CHECK(measurements.approachesFromOrder == set.captures.size());
  CHECK_FALSE(whyUntestable(measurements));
  for (std::size_t i = 0; i < set.captures.size(); i += 2) {
    set.captures[i].time = set.captures[i + 1].time; // pairs
  }
  CHECK(directions(built(set)) == expected);
  std::rotate(set.captures.begin(), set.captures.begin() + 10, set.captures.end());
  CHECK(directions(built(set)) == expected);
}

TEST_CASE("a joint that jitters within its rest keeps its direction") {
  // Proves it for readings that wander within the encoder's last digit, against the last angle that was a motion, and
  // that a slow motion counts once it is larger than the tolerance of a rest.
  CaptureSet set = unrecordedArm();
  const double step = 2 * 3.14159265 / 4096;
  for (std::size_t i = 0; i < set.captures.size(); ++i) {
    const double wander = (i % 3 == 0 ? -0.6 : 0.6) * step;
    angleOf(set.captures[i]) = i < 10 ? 0.1 : i < 20 ? 0.5 + wander : 0.5 - 0.4 * step * static_cast<double>(i);
  }
  angleOf(set.captures[0]) = 0.3;
  const std::vector<double> found = directions(built(set));
  CHECK(found[0] == 0);
  CHECK(std::all_of(found.begin() + 1, found.begin() + 10, [](double one) { return one == -1; }));
  CHECK(std::all_of(found.begin() + 10, found.begin() + 20, [](double one) { return one == 1; }));
  CHECK(std::all_of(found.begin() + 24, found.end(), [](double one) { return one == -1; }));
}

TEST_CASE("a direction that the order of captures cannot tell stays unknown") {
  // Proves it for captures of one time, for poses that were left and taken again with nothing in between, for stances,
  // and for a joint that always came from one side; and that hysteresis is not tested then.
  CaptureSet set = unrecordedArm();
  SECTION("one time") {
    for (Capture& capture : set.captures) {
      capture.time = Seconds{5};
    }
    CHECK(built(set).approachesFromOrder == 0);
  }
  SECTION("approached anew") {
    for (std::size_t i = 1; i < set.captures.size(); i += 2) {
      set.captures[i].pose = set.captures[i - 1].pose;
      set.captures[i].repeat = 1;
      set.captures[i].repeatKind = RepeatKind::reapproach;
      set.captures[i].joints.measured = set.captures[i - 1].joints.measured;
      set.captures[i].points = set.captures[i - 1].points;
    }
    const std::vector<double> found = directions(built(set));
    CHECK_FALSE(std::isnan(found[2]));
    CHECK(std::isnan(found[3]));
  }
  SECTION("put down anew") {
    set.stances.resize(30);
    for (int i = 0; i < 30; ++i) {
      set.stances[static_cast<std::size_t>(i)].id = i;
      set.stances[static_cast<std::size_t>(i)].supportFoot = set.stances.front().supportFoot;
      set.captures[static_cast<std::size_t>(i)].stance = i;
    }
    CHECK(built(set).approachesFromOrder < set.captures.size());
  }
  SECTION("from one side") {
    std::sort(set.captures.begin(), set.captures.end(), [](Capture a, Capture b) { return angleOf(a) < angleOf(b); });
    for (std::size_t i = 0; i < set.captures.size(); ++i) {
      set.captures[i].time = Seconds{static_cast<double>(i)};
    }
  }
  CHECK(whyUntestable(built(set)));
}

TEST_CASE("a direction of approach that was recorded stays") {
  // Proves it for a NAO, all of whose captures record directions that differ from the order, and for one capture of an
  // arm, from which the next ones of a resting joint take theirs.
  SimulationPlan plan;
  plan.poses = planStandingPoses(v6(), plan, SupportFoot::left, 4, 1);
  for (CommandedPose& pose : plan.poses) {
    pose.approach = Eigen::VectorXd::Ones(pose.angles.size());
  }
  const Measurements nao = buildMeasurements({simulate(v6(), plan, 1).set}, v6());
  CHECK(nao.approachesFromOrder == 0);
  for (const ImageObservation& picture : nao.pictures) {
    CHECK((picture.instant.approach.array() == 1).all());
  }
  CaptureSet arm = unrecordedArm();
  arm.captures[7].joints.approach = {1, angleOf(arm.captures[7]) > angleOf(arm.captures[6]) ? -1.0 : 1.0, 1, 1};
  angleOf(arm.captures[8]) = angleOf(arm.captures[7]);
  const std::vector<double> found = directions(built(arm));
  CHECK(found[7] == arm.captures[7].joints.approach[lift]);
  CHECK(found[8] == found[7]);
}

} // namespace naocal

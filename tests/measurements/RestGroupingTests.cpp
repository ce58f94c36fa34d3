#include "RobotV6.hpp"
#include "measurements/Measurements.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <vector>

namespace naocal {
namespace {

/// Four poses, each taken three times, without scatter between approaches.
CaptureSet takenThrice(RepeatKind kind) {
  SimulationPlan plan;
  plan.poses = planStandingPoses(v6(), plan, SupportFoot::left, 4, 1);
  plan.samples = 3;
  plan.repeatKind = kind;
  return simulate(v6(), plan, 1).set;
}

/// Number of encoder errors of a joint that the pose's readings have.
std::size_t countRests(const PoseGroup& pose) {
  std::set<std::vector<std::size_t>> errors;
  for (const EncoderSample& reading : pose.readings) {
    errors.insert(reading.encoderError);
  }
  return errors.size();
}

} // namespace

TEST_CASE("pictures at rest after different approaches do not share the error of one rest") {
  // Proves it for three approaches of a pose with two pictures each, the second one at rest, though all read the same
  // angles: three rests of the first pictures and three of the second.
  CaptureSet set = takenThrice(RepeatKind::reapproach);
  const std::vector<Capture> first = set.captures;
  for (Capture& capture : set.captures) {
    capture.repeat *= 2;
  }
  for (Capture again : first) {
    again.id += 1000;
    again.time += Seconds{0.1};
    again.repeat = 2 * again.repeat + 1;
    again.repeatKind = RepeatKind::rest;
    set.captures.push_back(again);
  }
  const Measurements measurements = buildMeasurements({set}, v6());
  for (const PoseGroup& pose : measurements.poses) {
    CHECK(countRests(pose) == 6);
    CHECK(pose.repeated);
  }
}

TEST_CASE("a robot that was put down anew has approached its pose anew, whatever the repeat's number") {
  // Proves it for repeats that are counted within each stance.
  CaptureSet set = takenThrice(RepeatKind::restand);
  const Measurements counted = buildMeasurements({set}, v6());
  for (Capture& capture : set.captures) {
    capture.repeat = 0;
  }
  const Measurements measurements = buildMeasurements({set}, v6());
  REQUIRE(measurements.poses.size() == counted.poses.size());
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    CHECK(measurements.poses[pose].repeated);
    CHECK(counted.poses[pose].repeated);
    CHECK(measurements.poses[pose].restood == counted.poses[pose].restood);
    CHECK(countRests(measurements.poses[pose]) == countRests(counted.poses[pose]));
  }
}

} // namespace naocal

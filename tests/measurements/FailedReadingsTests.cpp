#include "measurements/FailedReadings.hpp"

#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "measurements/Measurements.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// An arm in 30 poses; a tracker reads two markers and a frame in each.
CaptureSet trackedArm() {
  const TemporaryFolder folder;
  writeArmSet(folder.path() / "set", {.contacts = false});
  CaptureSet set = readCaptureSet(folder.path() / "set").set;
  set.folder.clear();
  return set;
}

std::vector<FailedReadings> failedOf(const CaptureSet& set) {
  return findFailedReadings(set, parseUrdf(measuredArmUrdf, "arm.urdf"));
}

Eigen::Vector3d& ball(CaptureSet& set, std::size_t capture) {
  return set.captures[capture].points[0].xyz;
}

/// All readings as of a tracker that was set to zero at this capture's ball.
CaptureSet zeroedAt(std::size_t capture) {
  CaptureSet set = trackedArm();
  const Eigen::Vector3d origin = ball(set, capture);
  for (Capture& each : set.captures) {
    for (PointReading& reading : each.points) {
      reading.xyz -= origin;
    }
    each.frames.front().xyz -= origin;
  }
  return set;
}

} // namespace

TEST_CASE("a tracker's readings at exactly 0, 0, 0 are none, and are left out") {
  // Proves it for several readings of a marker and one of a frame, and the sentence, which counts the target's
  // readings.
  CaptureSet set = trackedArm();
  CHECK(failedOf(set).empty());
  for (const std::size_t capture : {5, 17, 23}) {
    ball(set, capture).setZero();
  }
  set.captures[11].frames.front().xyz.setZero();
  const std::vector<FailedReadings> failed = failedOf(set);
  REQUIRE(failed.size() == 2);
  CHECK(failed[0].target == "ball");
  CHECK(failed[0].kind == FailedReadings::Kind::origin);
  CHECK(failed[0].captures == std::vector<std::size_t>{5, 17, 23});
  CHECK(describeFailedReadings(failed[0], set) == "3 of 30 readings of ball by laser are exactly 0, 0, 0: taken as no "
                                                  "reading and left out: captures 5, 17, 23");
  CHECK(failed[1].target == "tool");
  CHECK(failed[1].captures == std::vector<std::size_t>{11});
  const Measurements measurements = buildMeasurements({set}, parseUrdf(measuredArmUrdf, "arm.urdf"));
  CHECK(measurements.witnessCount == 3 * 30 - 4);
  CHECK(measurements.failedReadings.front().size() == 2);
}

TEST_CASE("a reading at the origin of a tracker that was set to zero there is a reading") {
  // Proves it for every capture of the arm as the one where the tracker was set to zero; and that 0, 0, 0 in another
  // capture still is none.
  for (std::size_t capture = 0; capture < 30; ++capture) {
    CaptureSet set = zeroedAt(capture);
    CAPTURE(capture);
    REQUIRE(ball(set, capture).isZero());
    CHECK(failedOf(set).empty());
    ball(set, (capture + 1) % 30).setZero();
    REQUIRE(failedOf(set).size() == 1);
    CHECK(failedOf(set).front().captures.size() == 2);
  }
}

TEST_CASE("a tracker's value that stands still while the arm moves is no reading") {
  // Proves that the first of equal readings in a row is kept, that all are left out where the value comes back later,
  // as it stands for nothing then, and that equal readings of one place stay.
  CaptureSet set = trackedArm();
  ball(set, 8) = ball(set, 9) = ball(set, 7);
  set.captures[20].joints = set.captures[19].joints;
  set.captures[20].points = set.captures[19].points;
  set.captures[20].frames = set.captures[19].frames;
  REQUIRE(failedOf(set).size() == 1);
  CHECK(failedOf(set).front().kind == FailedReadings::Kind::frozen);
  CHECK(failedOf(set).front().captures == std::vector<std::size_t>{8, 9});
  ball(set, 25) = ball(set, 7);
  CHECK(failedOf(set).front().captures == std::vector<std::size_t>{7, 8, 9, 25});
}

TEST_CASE("readings of planned captures, which are still to come, are not left out") {
  // Proves it for captures that were appended to recorded ones, as a search for the next poses does.
  CaptureSet set = trackedArm();
  for (std::size_t i = 0; i < 5; ++i) {
    Capture planned = set.captures[i];
    planned.id = static_cast<int>(100 + i);
    planned.pose = "planned " + std::to_string(i);
    planned.source.reset();
    planned.points.front().xyz.setZero();
    set.captures.push_back(planned);
  }
  CHECK(failedOf(set).empty());
}

} // namespace naocal

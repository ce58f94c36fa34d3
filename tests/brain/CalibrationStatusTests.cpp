#include "brain/CalibrationStatus.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using Json = nlohmann::json;

CalibrationStep step(const std::string& name, int pictures) {
  CalibrationStep result;
  result.name = name;
  result.pictures = pictures;
  result.points.resize(1);
  return result;
}

} // namespace

TEST_CASE("a joint that was hardly observed is told in words, with the poses in which no board was seen") {
  // Proves that offsets are published in degrees beside the previous values, only for learned joints, and the warning's
  // sentence.
  StoredResult before;
  before.values["jointOffset@LHipPitch.o"] = 0.005;
  const std::vector<EffectiveOffset> applied{{"LKneePitch", 0.02, 0.08, 0.12}, {"LHipPitch", 0.01, 0.001, 0.99}};
  const std::vector<PublishedCapture> captures{{1, 0, "P4", "top", 0, {}},  {2, 0, "P4", "bottom", 3, {"A"}},
                                               {3, 0, "P5", "top", 0, {}},  {4, 0, "P5", "bottom", 24, {"A"}},
                                               {5, 0, "P7", "top", {}, {}}, {6, 1, "P8", "top", 0, {}}};
  const PublishedOutcome outcome = summarizeOutcome(before, applied, captures);
  REQUIRE(outcome.joints.size() == 1);
  CHECK(outcome.joints[0].before == Approx(0.2865).epsilon(1e-3));
  CHECK(outcome.joints[0].after == Approx(0.5730).epsilon(1e-3));
  REQUIRE(outcome.warnings.size() == 1);
  CHECK(outcome.warnings[0] == "The left knee pitch was hardly observed (learned 12 %) and stays as it was: take poses "
                               "P4, P7 again, in which no board was seen.");
}

TEST_CASE("what was set before a calibration is told with its outcome, to whoever comes later") {
  // Proves that `before` is published unchanged if set, and absent otherwise. Which values it holds is not tested.
  PublishedOutcome outcome;
  CHECK_FALSE(Json(outcome).contains("before"));
  outcome.before = R"({"Motion.JointCalibrationProvider": {"headYaw": 0.5}})";
  CHECK(Json(outcome)["before"]["Motion.JointCalibrationProvider"]["headYaw"] == 0.5);
}

TEST_CASE("the poses of a round are shown with the one that comes next") {
  // Proves that steps without pictures are omitted, and the index of the next pose before, at and after a pose.
  const CalibrationRound round{step("The left foot", 0), step("Pose 1", 2), step("Pose 1", 2), step("Pose 2", 2),
                               step("Back", 0)};
  CHECK(listPoses(0, round, 0).poses.size() == 3);
  CHECK(listPoses(0, round, 0).step == 0);
  CHECK(listPoses(0, round, 1).step == 0);
  CHECK(listPoses(0, round, 3).step == 2);
  CHECK(listPoses(1, round, 4).step == 3);
  CHECK(Json(listPoses(1, round, 2))["poses"][0]["name"] == "Pose 1");
}

} // namespace naocal

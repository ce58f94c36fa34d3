#include "RobotV6.hpp"
#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// One proposed pose, every joint at zero or its nearest limit.
NextPoses proposed() {
  ProposedPose pose;
  pose.pose.angles.setZero(static_cast<Eigen::Index>(v6().joints.size()));
  pose.approach.setOnes(pose.pose.angles.size());
  for (std::size_t joint = 0; joint < v6().joints.size(); ++joint) {
    const AngleRange limits = v6().joints[joint].limits;
    pose.pose.angles[static_cast<Eigen::Index>(joint)] = std::clamp(0.0, limits.lower, limits.upper);
  }
  pose.pose.sights = {{"top", "A", {1, 2}}, {"bottom", "A", {3}}, {"top", "C", {4}}};
  NextPoses next;
  next.poses = {pose};
  next.why = "tells one thing from another";
  next.firstStance = 3;
  next.jointError = 0.03;
  return next;
}

} // namespace

TEST_CASE("a pose file is read as it was written, and holds every key that others rely on") {
  // Proves the round trip of one pose, and the keys of the file format.
  const TemporaryFolder folder;
  const NextPoses next = proposed();
  const nlohmann::json written = posesJson(next, v6());
  writeAtomically(folder.path() / "poses.json", written.dump());
  const PoseFile read = readPoseFile(folder.path() / "poses.json", v6());
  REQUIRE(read.poses.size() == 1);
  CHECK(read.firstStance == 3);
  CHECK(read.jointError == 0.03);
  CHECK(read.poses[0].supportFoot == SupportFoot::left);
  CHECK(read.poses[0].angles == next.poses[0].pose.angles);
  CHECK(read.poses[0].approach == next.poses[0].approach);
  CHECK(written.at("poses")[0].at("joints").size() == 26);
  CHECK(written.at("poses")[0].at("observes") == nlohmann::json({"A", "C"}));
  CHECK(written.at("poses")[0].at("secondsToReach").is_number());
  for (const char* key : {"format", "version", "robot", "support", "candidates", "boards", "predictedSigma",
                          "criterion", "assumptions", "why"}) {
    CHECK(written.contains(key));
  }
}

TEST_CASE("a pose file that cannot be played is refused in one sentence") {
  // Proves each fault's message and place. Examples cannot prove that every other fault is refused.
  const auto [fault, sentence] = GENERATE(table<std::function<void(nlohmann::json&)>, std::string>(
      {{[](auto& file) { file["format"] = "naocal-captures"; }, "format: expected one of naocal-poses"},
       {[](auto& file) { file["robot"] = "V4"; }, "robot: expected poses for the V6, found \"V4\""},
       {[](auto& file) { file["poses"].clear(); }, "poses: expected at least one pose"},
       {[](auto& file) { file["poses"][0]["joints"].erase("LKneePitch"); }, "found no LKneePitch"},
       {[](auto& file) { file["poses"][0]["joints"]["Tail"] = 0; }, "expected a joint of the V6, found \"Tail\""},
       {[](auto& file) { file["poses"][0]["joints"]["LKneePitch"] = 2.5; }, "LKneePitch: expected an angle from"},
       {[](auto& file) { file["poses"][0]["joints"]["RHipYawPitch"] = -0.1; }, "one motor drives both"},
       {[](auto& file) { file["poses"][0]["joints"]["HeadYaw"] = "NaN"; },
        "poses[0].joints.HeadYaw: expected a number"},
       {[](auto& file) { file["poses"][0]["approach"]["HeadYaw"] = 2; }, "poses[0].approach.HeadYaw"},
       {[](auto& file) { file["poses"][0]["supportFoot"] = "none"; }, "poses[0].supportFoot: expected"},
       {[](auto& file) { file["firstStance"] = -1; }, "firstStance: expected"}}));
  const TemporaryFolder folder;
  nlohmann::json file = posesJson(proposed(), v6());
  fault(file);
  writeAtomically(folder.path() / "poses.json", file.dump());
  CHECK_THROWS_WITH(readPoseFile(folder.path() / "poses.json", v6()), Catch::Contains(sentence));
}

} // namespace naocal

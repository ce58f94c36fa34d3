#include "robot/LiveExpectation.hpp"

#include "robot/Kinematics.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using Json = nlohmann::json;

const Robot& v6() {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  return robot;
}

LiveCamera turnedCamera() {
  LiveCamera result;
  result.intrinsics.fx = result.intrinsics.fy = 560;
  result.intrinsics.cx = 320;
  result.intrinsics.cy = 240;
  result.rotation = {0.01, 0, 0};
  return result;
}

Eigen::VectorXd looking(double yaw = 0, double right = 0) {
  return *parseNamedAngles({{"HeadPitch", 0.35},
                            {"HeadYaw", yaw},
                            {"RHipPitch", -right},
                            {"RKneePitch", 2 * right},
                            {"RAnklePitch", -right}},
                           v6());
}

const std::vector<Eigen::Vector2d> onFloorAhead{{150, 200}, {500, 200}, {150, 400}, {500, 400}};

Json offsets(double value, const std::string& unset = "") {
  Json list = Json::array();
  for (const Joint& joint : v6().joints) {
    std::string key = joint.name;
    key[0] = static_cast<char>(std::tolower(key[0]));
    list.push_back({{"key", key}, {"value", joint.name.starts_with(unset) && !unset.empty() ? 0 : value}});
  }
  return list;
}

LiveExpectation expectation(const Json& offsets, const Eigen::VectorXd& angles,
                            const LiveCamera& modelState = turnedCamera()) {
  return predictLiveError(v6(), angles, "top", modelState, onFloorAhead,
                          findUncalibrated(v6(), offsets, {{"top", modelState}}));
}

} // namespace

TEST_CASE("a live comparison names the limb that was never calibrated and what it may be off by") {
  // Proves the message for a robot on both feet whose right leg has no offsets, and that standing on the left foot
  // only, the right leg does not matter.
  const LiveExpectation both = expectation(offsets(0.5, "R"), looking());
  CHECK(both.joints.size() == 6);
  CHECK(both.px > 5);
  const std::string sentence = both.sentence(v6(), "top");
  INFO(sentence);
  CHECK(sentence.starts_with("The right leg was never calibrated: errors up to "));
  CHECK(expectation(offsets(0.5, "R"), looking(0, 0.6)).px == 0);
  CHECK(expectation(offsets(0.5), looking()).sentence(v6(), "top") ==
        "All joints between the floor and this camera are calibrated.");
}

TEST_CASE("what a single joint may be off by is what its turn does to the picture") {
  // Checks the order of magnitude: a neck pitch of dq shifts a point straight ahead by about f dq in the image, and the
  // boards' estimated placement absorbs a part.
  const LiveExpectation pitch = expectation(offsets(0.5, "HeadPitch"), looking());
  CHECK(pitch.joints == std::vector<std::string>{"HeadPitch"});
  CHECK(pitch.px > 0.05 * 560 * 0.1); // sigma of an offset: 0.1 rad
  CHECK(pitch.px < 1.3 * 560 * 0.1);
}

TEST_CASE("a turn that boards on the floor take up shows nowhere, so it is not expected to") {
  // Proves that a head yaw offset, which rotates the whole floor, does not count: on an upright robot the axis is
  // vertical.
  const LiveExpectation yaw = expectation(offsets(0.5, "HeadYaw"), looking(0.4));
  CHECK(yaw.joints.empty());
  CHECK(yaw.px < 1);
}

TEST_CASE("a camera that sits as drawn was not calibrated") {
  // Proves that an uncalibrated mount counts in addition to the joints and is named; a calibrated one does not count.
  LiveCamera asDrawn = turnedCamera();
  asDrawn.rotation.setZero();
  const LiveExpectation mount = expectation(offsets(0.5), looking(), asDrawn);
  CHECK(mount.camera);
  CHECK(mount.px > 1);
  CHECK(mount.sentence(v6(), "top").starts_with("The top camera's mount was never calibrated"));
  CHECK_THROWS_AS(findUncalibrated(v6(), Json{{{"key", 3}}}, {}), Json::exception);
}

} // namespace naocal

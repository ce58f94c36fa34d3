#include "robot/FloorScene.hpp"

#include "data/CaptureSetFile.hpp"
#include "robot/Kinematics.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using Json = nlohmann::json;

const Robot& drawing() {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  return robot;
}

RobotOutline standing(const std::map<std::string, double>& angles) {
  return {drawing(), *parseNamedAngles(Json(angles), drawing())};
}

LiveCamera camera() {
  LiveCamera result;
  result.intrinsics.fx = result.intrinsics.fy = 560;
  result.intrinsics.cx = 320;
  result.intrinsics.cy = 240;
  return result;
}

Board board() {
  Board result;
  result.id = "A";
  result.pattern = CharucoPattern{};
  result.points = innerCorners(*result.pattern);
  return result;
}

/// Projection of a point on the floor, by the pinhole formula.
Eigen::Vector2d seenAt(const Eigen::Vector3d& onFloor, const CameraView& eye) {
  const Eigen::Vector3d p = eye.floorFromOptical.rotation.transpose() * (onFloor - eye.floorFromOptical.translation);
  return {eye.lens.cx + eye.lens.fx * p.x() / p.z(), eye.lens.cy + eye.lens.fy * p.y() / p.z()};
}

BoardCorners view(const Board& shown, const Placement& place, const CameraView& eye) {
  BoardCorners corners{shown.id, {}, {}};
  for (std::size_t i = 0; i < shown.points.size(); ++i) {
    const Eigen::Vector3d turned = rotationZ(place.yaw) * shown.points[i];
    corners.ids.push_back(static_cast<int>(i));
    corners.uv.push_back(seenAt(turned + Eigen::Vector3d{place.x, place.y, 0}, eye));
  }
  return corners;
}

} // namespace

TEST_CASE("a robot stands on its lower foot, and on both where they are level") {
  // Proves which sole defines the floor, and that the supporting foot's outline surrounds the origin.
  CHECK(standing({}).toJson({})["carries"] == "both");
  const Json left = standing({{"RHipPitch", -0.6}, {"RKneePitch", 1.2}, {"RAnklePitch", -0.6}}).toJson({});
  CHECK(left["carries"] == "left");
  CHECK(standing({{"LHipPitch", -0.6}, {"LKneePitch", 1.2}, {"LAnklePitch", -0.6}}).toJson({})["carries"] == "right");
  double nearest = 1, farthest = -1;
  for (const Json& point : left["feet"]["left"]) {
    nearest = std::min(nearest, point[0].get<double>());
    farthest = std::max(farthest, point[0].get<double>());
  }
  CHECK(nearest < -0.04);
  CHECK(farthest > 0.09);
  CHECK(left["centre"][2] > 0.2); // height above the floor [m]
}

TEST_CASE("angles come in HULKs' order or by name, and nothing else is taken") {
  // Proves that both formats give the same joints, and the refusal of other lists.
  Json list(std::vector<double>(26, 0));
  list[1] = 0.3;  // head pitch
  list[17] = 0.9; // right knee pitch
  const auto angles = parseOrderedAngles(list, drawing());
  REQUIRE(angles);
  CHECK(*angles == *parseNamedAngles({{"HeadPitch", 0.3}, {"RKneePitch", 0.9}}, drawing()));
  CHECK_FALSE(parseOrderedAngles(Json(std::vector<double>(25, 0)), drawing()));
  CHECK_FALSE(parseOrderedAngles("all of them", drawing()));
  list[3] = "wide";
  CHECK_FALSE(parseOrderedAngles(list, drawing()));
}

TEST_CASE("a board lies where its corners are seen, and what is off shows as a distance from its prediction") {
  // Proves the board's placement against the test's own projection, for two head angles; and that a wrong head angle
  // separates corners and predictions.
  const Board shown = board();
  const Placement place{0.7, 0.1, 0, 0, 0, 0.4};
  FloorBoardTracker boards{{shown}};
  for (const double yaw : {0.0, 0.1}) {
    const CameraView eye{*standing({{"HeadPitch", 0.35}, {"HeadYaw", yaw}}).floorFromOptical("top", camera()),
                         camera().intrinsics};
    const BoardCorners seen = view(shown, place, eye);
    const auto predicted = boards.update(seen, eye);
    REQUIRE(predicted.size() == seen.uv.size());
    for (std::size_t i = 0; i < predicted.size(); ++i) {
      CHECK((predicted[i] - seen.uv[i]).norm() < 1e-6);
    }
  }
  const Json drawn = boards.toJson();
  CHECK(drawn[0]["x"] == Approx(place.x));
  CHECK(drawn[0]["y"] == Approx(place.y));
  CHECK(drawn[0]["yaw"] == Approx(place.yaw));

  const CameraView real{*standing({{"HeadPitch", 0.35}, {"HeadYaw", 0.02}}).floorFromOptical("top", camera()),
                        camera().intrinsics};
  const CameraView believed{*standing({{"HeadPitch", 0.35}}).floorFromOptical("top", camera()), camera().intrinsics};
  const BoardCorners seen = view(shown, place, real);
  CHECK((boards.update(seen, believed)[0] - seen.uv[0]).norm() > 3); // [px]; 0.02 rad * 560 px = 11 px, of which the
                                                                     // placement absorbs a part
}

TEST_CASE("a board that was moved is found anew, and a corner above the horizon tells nothing") {
  // Proves that former views of a moved board are discarded, and that corners above the horizon, unknown boards and
  // unknown corners are ignored.
  const Board shown = board();
  FloorBoardTracker boards{{shown}};
  const CameraView eye{*standing({{"HeadPitch", 0.35}}).floorFromOptical("top", camera()), camera().intrinsics};
  boards.update(view(shown, {0.7, 0.1, 0, 0, 0, 0}, eye), eye);
  boards.update(view(shown, {0.9, -0.2, 0, 0, 0, 0}, eye), eye);
  CHECK(boards.toJson()[0]["x"] == Approx(0.9));
  BoardCorners sky{"A", {0, 1, 2}, {{10, -4000}, {20, -4000}, {30, -4000}}};
  CHECK(boards.update(sky, eye).empty());
  sky.board = "Z";
  CHECK(boards.update(sky, eye).empty());
  BoardCorners larger = view(shown, {0.9, -0.2, 0, 0, 0, 0}, eye); // of a board that was replaced meanwhile
  larger.ids.back() = 1000;
  CHECK(boards.update(larger, eye).empty());
}

TEST_CASE("what a camera sees of the floor holds the point that it looks at, and ends after three metres") {
  // Proves the polygon by the optical axis' intersection with the floor, and its range.
  const RobotOutline robot = standing({{"HeadPitch", 0.2}});
  const Json drawn = robot.toJson({{"top", camera()}});
  const auto middle = intersectFloor(*robot.floorFromOptical("top", camera()), camera().intrinsics, {320, 240});
  REQUIRE(middle);
  double nearest = 10, farthest = 0;
  for (const Json& point : drawn["views"]["top"]) {
    nearest = std::min(nearest, point[0].get<double>());
    farthest = std::max(farthest, point[0].get<double>());
  }
  CHECK(nearest < middle->x());
  CHECK(farthest > middle->x());
  CHECK(farthest < 3.2);
  CHECK_FALSE(drawn["views"].contains("bottom"));
}

} // namespace naocal

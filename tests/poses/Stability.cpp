#include "RobotV6.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/Polygon.hpp"
#include "robot/Balance.hpp"
#include <algorithm>

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

/// On the left foot, the right one drawn up; `ankleRoll` [degrees] leans the whole robot.
ModelState onLeftFoot(const Robot& robot, double ankleRoll) {
  ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  const auto set = [&](const char* joint, double angle) {
    modelState.angle(*robot.jointIndex(joint)) = radians(angle);
  };
  set("RHipPitch", -30);
  set("RKneePitch", 60);
  set("RAnklePitch", -30);
  set("LAnkleRoll", ankleRoll);
  return modelState;
}

} // namespace

TEST_CASE("depth inside an outline is the distance to its nearest side") {
  // Proves it on a rectangle, inside, outside and on the edge; other shapes follow from the sides being lines.
  const ConvexPolygon rectangle{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  CHECK(insideDepth(rectangle, {1, 1.5}) == Approx(0.5));
  CHECK(insideDepth(rectangle, {2, 2}) == Approx(0).margin(1e-15));
  CHECK(insideDepth(rectangle, {5, 1}) == Approx(-1));
}

TEST_CASE("outlines are apart when a side parts them") {
  // Proves it for triangles side by side, nested, crossing, and parted by the second one's side only.
  const ConvexPolygon triangle{{0, 0}, {2, 0}, {0, 2}};
  const auto moved = [&](double x, double y) {
    ConvexPolygon result = triangle;
    for (Eigen::Vector2d& corner : result) {
      corner += Eigen::Vector2d{x, y};
    }
    return result;
  };
  CHECK(areSeparated(triangle, moved(2.1, 0)));
  CHECK(areSeparated(triangle, moved(1.1, 1.1)));
  CHECK_FALSE(areSeparated(triangle, triangle));
  CHECK_FALSE(areSeparated(triangle, moved(0.9, 0.9)));
  CHECK_FALSE(areSeparated(triangle, moved(-0.5, 0.5)));
  const ConvexPolygon flag{{3, -1}, {3, 5}, {2.1, 2}}; // its left corner points at the triangle
  CHECK(areSeparated(triangle, flag));
  CHECK(areSeparated(flag, triangle));
}

TEST_CASE("a robot stands while its centre of mass is over the sole and the other one in the air") {
  // Proves both conditions on one attitude that leans sideways over its ankle: the straight robot on one foot falls to
  // the other side, leaning over the foot it stands, leaning farther it falls outwards; and the foot must be lifted.
  const Robot robot = v6();
  const auto at = [&](double ankleRoll) { return forwardKinematics(robot, onLeftFoot(robot, ankleRoll)); };
  CHECK_FALSE(isBalanced(robot, at(0), SupportFoot::left, {}));
  CHECK(isBalanced(robot, at(11), SupportFoot::left, {}));
  CHECK_FALSE(isBalanced(robot, at(25), SupportFoot::left, {}));
  CHECK_FALSE(isBalanced(robot, at(11), SupportFoot::left, {0.06, 0})); // the sole is less than 12 cm wide
  CHECK_FALSE(isBalanced(robot, at(11), SupportFoot::left, {0, 0.2}));

  ModelState bothDown = onLeftFoot(robot, 11);
  bothDown.angle(*robot.jointIndex("RHipPitch")) = 0;
  bothDown.angle(*robot.jointIndex("RKneePitch")) = 0;
  bothDown.angle(*robot.jointIndex("RAnklePitch")) = radians(40); // toes down
  CHECK_FALSE(isBalanced(robot, forwardKinematics(robot, bothDown), SupportFoot::left, {}));
}

TEST_CASE("the share of robots that stand despite errors falls as the errors grow") {
  // Proves that errors are drawn and counted: without any, all stand; with small ones all do; with large ones not even
  // half; and that a robot that does not stand by itself never passes. It does not prove the distribution.
  const Robot robot = v6();
  std::mt19937_64 random{3};
  const auto passes = [&](double ankleRoll, double errorDegrees, double share) {
    return balancedFraction(robot, onLeftFoot(robot, ankleRoll), SupportFoot::left, {radians(errorDegrees), 200, share},
                            random)
        .has_value();
  };
  CHECK(passes(11, 0, 1));
  CHECK(passes(11, 1, 1));
  CHECK_FALSE(passes(11, 15, 0.99));
  CHECK_FALSE(passes(11, 60, 0.5));
  CHECK_FALSE(passes(0, 0, 0.01));
}

TEST_CASE("a robot without soles is refused") {
  // Proves it for a drawing without any.
  Robot robot = v6();
  robot.soles.clear();
  CHECK_THROWS_WITH(supportSole(robot, SupportFoot::left), Catch::Contains("expected a left sole"));
}

TEST_CASE("a point is within the hull of points where it is inside their convex outline") {
  // Proves the quick test against the outline's sides for 2000 random points and sets, and the outline itself: every
  // point of a set lies in it, and its corners are of the set and run counter-clockwise.
  std::mt19937_64 random{8};
  std::uniform_real_distribution<double> unit{-1, 1};
  int within = 0;
  for (int draw = 0; draw < 2000; ++draw) {
    ConvexPolygon points(3 + draw % 9);
    for (Eigen::Vector2d& point : points) {
      point = {unit(random), unit(random)};
    }
    const ConvexPolygon outline = convexHull(points);
    for (const Eigen::Vector2d& point : points) {
      CHECK(insideDepth(outline, point) > -1e-12);
    }
    for (const Eigen::Vector2d& corner : outline) {
      CHECK(std::find(points.begin(), points.end(), corner) != points.end());
    }
    const Eigen::Vector2d point{unit(random), unit(random)};
    CHECK(hullContains(points, point) == (insideDepth(outline, point) > 0));
    within += hullContains(points, point) ? 1 : 0;
  }
  CHECK(within > 300);
  CHECK(within < 1700);
}

TEST_CASE("a robot on both feet stands where its centre of mass is between them, whatever one foot alone would do") {
  // Proves it for the straight robot, which falls from one foot, and for one whose soles are turned over both ankles:
  // they lie on the plane between them. The soles are 155 mm long, so that no one is 80 mm inside both ends.
  const Robot robot = v6();
  const auto leaning = [&](double ankleRoll) {
    ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
    for (const char* joint : {"LAnkleRoll", "RAnkleRoll"}) {
      modelState.angle(*robot.jointIndex(joint)) = radians(ankleRoll);
    }
    return forwardKinematics(robot, modelState);
  };
  CHECK_FALSE(isBalanced(robot, leaning(0), SupportFoot::left, {}));
  CHECK(isBalanced(robot, leaning(0), SupportFoot::both, {0.04, 0}));
  CHECK(isBalanced(robot, leaning(8), SupportFoot::both, {}));
  CHECK_FALSE(isBalanced(robot, leaning(0), SupportFoot::both, {0.08, 0}));
}

#include "RobotV6.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/Polygon.hpp"
#include "robot/Balance.hpp"
#include <algorithm>

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

/// Standing on the left foot, the right one lifted; `ankleRoll` [degrees] leans the whole robot.
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
  // Proves it on a rectangle, inside, outside and on the edge.
  const ConvexPolygon rectangle{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  CHECK(insideDepth(rectangle, {1, 1.5}) == Approx(0.5));
  CHECK(insideDepth(rectangle, {2, 2}) == Approx(0).margin(1e-15));
  CHECK(insideDepth(rectangle, {5, 1}) == Approx(-1));
}

TEST_CASE("outlines are apart when a side parts them") {
  // Proves it for triangles side by side, nested, overlapping, and separated by a side of the second one only.
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
  // Proves both conditions on one pose leaning over its ankle: upright, the robot falls inwards; leaning over the foot
  // it stands; leaning further it falls outwards; and the other foot must be lifted.
  const Robot robot = v6();
  const auto at = [&](double ankleRoll) { return forwardKinematics(robot, onLeftFoot(robot, ankleRoll)); };
  CHECK_FALSE(isBalanced(robot, at(0), SupportFoot::left, {}));
  CHECK(isBalanced(robot, at(11), SupportFoot::left, {}));
  CHECK_FALSE(isBalanced(robot, at(25), SupportFoot::left, {}));
  CHECK_FALSE(isBalanced(robot, at(11), SupportFoot::left, {0.06, 0})); // the sole is narrower than 12 cm
  CHECK_FALSE(isBalanced(robot, at(11), SupportFoot::left, {0, 0.2}));

  ModelState bothDown = onLeftFoot(robot, 11);
  bothDown.angle(*robot.jointIndex("RHipPitch")) = 0;
  bothDown.angle(*robot.jointIndex("RKneePitch")) = 0;
  bothDown.angle(*robot.jointIndex("RAnklePitch")) = radians(40); // toes down
  CHECK_FALSE(isBalanced(robot, forwardKinematics(robot, bothDown), SupportFoot::left, {}));
}

TEST_CASE("the share of robots that stand despite errors falls as the errors grow") {
  // Proves that errors are drawn and counted: without or with small errors all robots stand, with large ones less than
  // half; a robot that is unbalanced without errors never passes. The distribution is not tested.
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
  // Proves it for a drawing without soles.
  Robot robot = v6();
  robot.soles.clear();
  CHECK_THROWS_WITH(supportSole(robot, SupportFoot::left), Catch::Contains("expected a left sole"));
}

TEST_CASE("a point is within the hull of points where it is inside their convex outline") {
  // Compares the quick test with the outline's sides for 2000 random points and sets; also the outline: it contains
  // every point of the set, and its corners are from the set in counter-clockwise order.
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
  // Proves it for the upright robot, which would fall from one foot, and for one with both ankles rolled, whose soles
  // define the floor between them. Soles are 155 mm long, so no point has a margin of 80 mm at both ends.
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

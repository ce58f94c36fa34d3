#include "RobotV6.hpp"
#include "math/Angles.hpp"
#include "robot/SelfCollision.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace naocal;

namespace {

struct Turn {
  const char* joint;
  double degrees;
};

bool touches(const std::vector<Turn>& turns) {
  const Robot& robot = v6();
  ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  moveToRest(robot, modelState);
  for (const Turn& turn : turns) {
    modelState.angle(*robot.jointIndex(turn.joint)) = radians(turn.degrees);
  }
  return SelfCollision{robot}.collides(forwardKinematics(robot, modelState));
}

} // namespace

TEST_CASE("a robot that crosses its legs, kicks its shin or bends onto its thigh touches itself") {
  // Proves the hull for postures with an obvious answer, in both directions. The capsules are coarse: postures within a
  // centimetre of contact are not tested.
  CHECK_FALSE(touches({}));
  CHECK_FALSE(touches({{"LKneePitch", 110}, {"LHipPitch", -60}, {"LAnklePitch", -50}}));
  CHECK_FALSE(touches({{"LHipRoll", 20}, {"RHipRoll", -20}}));
  CHECK_FALSE(touches({{"LShoulderRoll", 60}, {"RShoulderRoll", -60}}));
  CHECK(touches({{"LHipRoll", -20}, {"RHipRoll", 20}}));
  CHECK(touches({{"RHipRoll", 25}, {"RHipPitch", -10}}));
  CHECK(touches({{"LShoulderRoll", -18}, {"LElbowRoll", -80}, {"LShoulderPitch", 60}}));
}

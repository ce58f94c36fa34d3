#pragma once

#include "robot/Robot.hpp"
#include "simulation/Simulation.hpp"

#include <fmt/format.h>
#include <string>
#include <vector>

namespace naocal {

/// Poses for tests that do not need balance: knees bent, torso within a quarter of a radian of upright, the head
/// looking around, the free leg anywhere, arms hanging.
inline std::vector<CommandedPose> handMadePoses(const Robot& robot, SupportFoot foot, int count,
                                                std::uint64_t seed = 1) {
  RandomStream chance{seed, "hand-made poses"};
  std::vector<CommandedPose> poses;
  for (int i = 0; i < count; ++i) {
    CommandedPose pose{fmt::format("P{:02}", i), foot,
                       Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()))};
    const auto set = [&](const std::string& joint, double angle) {
      pose.angles[static_cast<Eigen::Index>(*robot.jointIndex(joint))] = angle;
    };
    set("HeadYaw", chance.uniformWithin(0.9));
    set("HeadPitch", 0.05 + chance.uniformWithin(0.35));
    const double hipYawPitch = -0.2 + chance.uniformWithin(0.3);
    const bool symmetric = foot == SupportFoot::both;
    double roll = chance.uniformWithin(0.25), hip = -0.6 + chance.uniformWithin(0.3),
           knee = 0.8 + chance.uniformWithin(0.4);
    double pitch = chance.uniformWithin(0.25);
    for (const std::string side : {"L", "R"}) {
      set(side + "ShoulderPitch", radians(90));
      set(side + "HipYawPitch", symmetric ? 0 : hipYawPitch);
      set(side + "HipRoll", roll);
      set(side + "HipPitch", hip);
      set(side + "KneePitch", knee);
      set(side + "AnklePitch", -hip - knee + pitch);
      set(side + "AnkleRoll", -roll + (symmetric ? 0 : chance.uniformWithin(0.15)));
      if (!symmetric) {
        roll = chance.uniformWithin(0.25), hip = -0.6 + chance.uniformWithin(0.3),
        knee = 0.8 + chance.uniformWithin(0.4);
      }
    }
    poses.push_back(pose);
  }
  return poses;
}

/// A plan with those poses and default values otherwise.
inline SimulationPlan handMadePlan(const Robot& robot, int poses = 12, SupportFoot foot = SupportFoot::left) {
  SimulationPlan plan;
  plan.poses = handMadePoses(robot, foot, poses);
  return plan;
}

} // namespace naocal

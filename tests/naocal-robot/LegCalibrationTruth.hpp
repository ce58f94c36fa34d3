#pragma once

#include "SimulatedProcess.hpp"

#include "calibration/result/ResultFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "simulation/RobotErrors.hpp"
#include "simulation/SyntheticBody.hpp"
#include "simulation/SyntheticRobot.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

/// Ground truth of a leg calibration, from the simulated robot's mechanics, which share no code with the program.
class LegCalibrationTruth {
public:
  LegCalibrationTruth(const Robot& drawing, const SimulatedErrors& errors, const ServoMechanics& servos)
      : drawing_{drawing}, errors_{errors}, servos_{servos}, robot_{drawing, errors.robot, RobotMechanics{}} {}

  /// Encoder error of a joint under load, o - D/2 sgn(tau); below the gear's friction the joint lags behind its motor.
  /// Mean over the captures [rad].
  double shownTooMuch(std::size_t joint, const CaptureSet& set) const {
    double sum = 0;
    int count = 0;
    for (const Capture& capture : set.captures) {
      if (movesInSight(joint, capture.supportFoot)) {
        sum += errors_.robot.jointOffsets[eigenIndex(joint)] -
               gaps(capture.supportFoot, motors(set, capture), &capture.joints.approach)[eigenIndex(joint)];
        ++count;
      }
    }
    return sum / count;
  }

  /// Error of the top camera's view of a floor point 2 m ahead of a foot, standing on that foot with bent knees and
  /// straight head, with a calibration's offsets and mounts [m].
  double floorError(SupportFoot foot, const StoredResult& calibration) const {
    Eigen::VectorXd motor = Eigen::VectorXd::Zero(eigenIndex(drawing_.joints.size()));
    for (const char* side : {"L", "R"}) {
      for (const auto& [name, angle] :
           {std::pair{"HipPitch", -25.0}, std::pair{"KneePitch", 50.0}, std::pair{"AnklePitch", -25.0}}) {
        motor[eigenIndex(*drawing_.jointIndex(side + std::string{name}))] = radians(angle);
      }
    }
    const std::size_t top = *drawing_.cameraIndex("top");
    const auto value = [&](const std::string& name) {
      const auto known = calibration.values.find(name);
      return known == calibration.values.end() ? 0 : known->second;
    };
    const Eigen::VectorXd really = motor + gaps(foot, motor, nullptr);
    Eigen::VectorXd believed = motor + errors_.robot.jointOffsets;
    for (std::size_t joint = 0; joint < drawing_.joints.size(); ++joint) {
      const std::string& name = drawing_.joints[drawing_.joints[joint].motor].name;
      believed[eigenIndex(joint)] -= value("jointOffset@" + name + ".o");
    }
    RobotErrors found = errors_.robot;
    for (int axis = 0; axis < 3; ++axis) {
      found.mounts[top].rotation[axis] = value(std::string{"cameraRotation@top.r"} + "xyz"[axis]);
    }
    const SyntheticRobot perceived{drawing_, found, RobotMechanics{}};
    const Eigen::Vector3d point{2, 0, 0};
    const Eigen::Vector3d seen =
        robot_.torsoFromCamera(top, really).inverse() * (robot_.soleFromTorso(really, foot).inverse() * point);
    const Eigen::Isometry3d soleFromCamera =
        perceived.soleFromTorso(believed, foot) * perceived.torsoFromCamera(top, believed);
    const Eigen::Vector3d eye = soleFromCamera.translation(), ray = soleFromCamera.linear() * seen;
    return ray.z() < 0 ? (eye - eye.z() / ray.z() * ray - point).norm() : std::numeric_limits<double>::infinity();
  }

private:
  /// Whether the joint lies between the sole and a camera.
  bool movesInSight(std::size_t joint, SupportFoot foot) const {
    const std::string& name = drawing_.joints[joint].name;
    return name.starts_with("Head") || name.find("HipYawPitch") != std::string::npos ||
           name.starts_with(foot == SupportFoot::left ? "L" : "R");
  }
  Eigen::VectorXd motors(const CaptureSet& set, const Capture& capture) const {
    Eigen::VectorXd motor{eigenIndex(drawing_.joints.size())};
    for (std::size_t i = 0; i < set.jointNames.size(); ++i) {
      if (const auto joint = drawing_.jointIndex(set.jointNames[i])) {
        motor[eigenIndex(*joint)] = capture.joints.measured[i] - errors_.robot.jointOffsets[eigenIndex(*joint)];
      }
    }
    return motor;
  }
  /// `approach`: indexed by hardware joint; nullptr: unloaded gears are centred.
  Eigen::VectorXd gaps(SupportFoot foot, const Eigen::VectorXd& motor, const std::vector<double>* approach) const {
    const Eigen::VectorXd torques = robot_.gravityTorques(motor, foot);
    Eigen::VectorXd result{motor.size()};
    for (std::size_t joint = 0; joint < drawing_.joints.size(); ++joint) {
      const double torque = torques[eigenIndex(joint)], half = errors_.play[joint] / 2;
      const double trailing =
          approach && !approach->empty() ? -half * approach->at(*jointIndex(drawing_.joints[joint].name)) : 0;
      result[eigenIndex(joint)] = std::abs(torque) > servos_.gearFriction ? std::copysign(half, torque) : trailing;
    }
    return result;
  }

  const Robot& drawing_;
  const SimulatedErrors& errors_;
  ServoMechanics servos_;
  SyntheticRobot robot_;
};

} // namespace naocal

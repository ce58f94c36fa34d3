#include "world/Mechanism.hpp"

#include <algorithm>
#include <cmath>

namespace blind {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

bool feelsLoad(const JointFlaws& flaws) {
  return flaws.gap != 0 || flaws.compliance != 0 || flaws.rootSag != 0;
}

/// Processes a session in order of time: play depends on the motion history.
class Walk {
public:
  Walk(const Robot& robot, const Session& session, const Skeleton& skeleton)
      : robot_{robot}, session_{session}, skeleton_{skeleton} {
    for (const JointFlaws& flaws : robot.flaws.joints) {
      gaps_.emplace_back(flaws.gap, flaws.gapFriction);
      lags_.emplace_back(flaws.lag);
      loaded_ = loaded_ || feelsLoad(flaws);
    }
  }

  VectorXd angles(const Reading& reading) {
    const VectorXd motors = motorAngles(reading);
    const bool first = before_.size() == 0;
    const int side = session_.stances[reading.stance].side;
    if (reading.kind != RepeatKind::rest || reading.repeat == 0) {
      const VectorXd aside = motors + reading.excursion;
      for (Index i = 0; i < motors.size(); ++i) {
        if (first) {
          gaps_[i].start(aside[i]);
          lags_[i].start(aside[i]);
        }
        lags_[i].pushTo(aside[i]);
      }
      walk(first ? aside : before_, aside, side);
      walk(aside, motors, side);
    }
    VectorXd links = motors;
    for (Index i = 0; i < motors.size(); ++i) {
      lags_[i].pushTo(motors[i]);
      links[i] += lags_[i].link() - motors[i] + reading.stuck[i];
    }
    before_ = motors;
    return balanced(links, motors, side);
  }

private:
  VectorXd motorAngles(const Reading& reading) const {
    const VectorXd read = reading.measured + reading.unread - robot_.offsets;
    VectorXd motors = read;
    const double elapsed = reading.time - session_.readings.front().time;
    for (Index i = 0; i < read.size(); ++i) {
      const JointFlaws& flaws = robot_.flaws.joints[static_cast<std::size_t>(i)];
      motors[i] = linkAngle(read[i], flaws) + flaws.warming * (reading.temperature[i] - 30) + flaws.creep * elapsed +
                  flaws.ripple * std::sin(6 * read[i]) + (reading.time >= flaws.slipTime ? flaws.slip : 0);
      if (flaws.puller >= 0) {
        motors[i] += flaws.pulled * read[flaws.puller] + flaws.pulledByMagnitude * std::abs(read[flaws.puller]);
      }
    }
    return motors;
  }

  VectorXd torques(const VectorXd& angles, int side) const {
    const Skeleton::Posture posture = skeleton_.posture(angles);
    const SoleFlaws& sole = robot_.flaws.soles[side];
    const Eigen::Vector3d upInSole = tiltRotation(sole.roll, sole.pitch).transpose() * Eigen::Vector3d::UnitZ();
    return skeleton_.torques(posture, side, skeleton_.torsoFromSole(posture, side).turn * upInSole);
  }

  /// Moves all motors along a straight line; the load takes up play on the way.
  void walk(const VectorXd& from, const VectorXd& to, int side) {
    constexpr int steps = 4;
    if (std::none_of(robot_.flaws.joints.begin(), robot_.flaws.joints.end(),
                     [](const JointFlaws& flaws) { return flaws.gap != 0; })) {
      return;
    }
    for (int step = 1; step <= steps; ++step) {
      const VectorXd motors = from + (to - from) * step / steps;
      const VectorXd load = torques(motors, side);
      for (Index i = 0; i < motors.size(); ++i) {
        gaps_[i].pushTo(motors[i]);
        gaps_[i].applyLoad(motors[i], load[i]);
      }
    }
  }

  /// Deflects springs in equilibrium with gravity in the resulting posture (fixed-point iteration).
  VectorXd balanced(VectorXd links, const VectorXd& motors, int side) const {
    for (Index i = 0; i < links.size(); ++i) {
      links[i] += robot_.flaws.joints[i].gap != 0 ? gaps_[i].link() - motors[i] : 0;
    }
    followMotor(links);
    if (!loaded_) {
      return links;
    }
    constexpr int rounds = 6; // each reduces the error to 1 % or less
    VectorXd sagged = links;
    for (int round = 0; round < rounds; ++round) {
      const VectorXd load = torques(sagged, side);
      for (Index i = 0; i < links.size(); ++i) {
        const JointFlaws& flaws = robot_.flaws.joints[i];
        sagged[i] = links[i] + flaws.compliance * load[i] +
                    flaws.rootSag * std::copysign(std::sqrt(std::abs(load[i])), load[i]);
      }
      followMotor(sagged);
    }
    return sagged;
  }

  void followMotor(VectorXd& angles) const {
    const auto& joints = robot_.drawing->joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (!joints[i].drivenBy.empty()) {
        angles[i] = angles[robot_.drawing->joint(joints[i].drivenBy)];
      }
    }
  }

  const Robot& robot_;
  const Session& session_;
  const Skeleton& skeleton_;
  std::vector<Play> gaps_, lags_;
  VectorXd before_;
  bool loaded_ = false;
};

} // namespace

double linkAngle(double read, const JointFlaws& flaws) {
  double angle = (1 + flaws.gain) * read;
  if (flaws.magnetX == 0 && flaws.magnetY == 0) {
    return angle;
  }
  const double shown = angle;
  for (int round = 0; round < 8; ++round) { // converges fast: the eccentricity is small
    const double field = std::atan2(std::sin(angle) + flaws.magnetY, std::cos(angle) + flaws.magnetX);
    angle += std::remainder(shown - field, 2 * M_PI);
  }
  return angle;
}

std::vector<VectorXd> trueAngles(const Robot& robot, const Session& session, const Skeleton& skeleton) {
  Walk walk{robot, session, skeleton};
  std::vector<VectorXd> angles;
  for (const Reading& reading : session.readings) {
    angles.push_back(walk.angles(reading));
  }
  return angles;
}

Eigen::Matrix3d soleTilt(const SoleFlaws& flaws, const Eigen::Vector3d& centreInSole) {
  Eigen::Matrix3d tilt = tiltRotation(flaws.roll, flaws.pitch);
  for (int round = 0; flaws.compliance != 0 && round < 6; ++round) {
    const Eigen::Vector3d centre = tilt * centreInSole;
    tilt = tiltRotation(flaws.roll - flaws.compliance * centre.y(), flaws.pitch + flaws.compliance * centre.x());
  }
  return tilt;
}

} // namespace blind

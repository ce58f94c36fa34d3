#include "writer/SessionPlanner.hpp"

#include "world/Pictures.hpp"
#include "world/RandomStream.hpp"
#include "writer/Poses.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace blind {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Motor temperatures with a first-order lag: dT/dt = (room + heat * torque^2 - T) / slowness.
class MotorTemperatures {
public:
  MotorTemperatures(std::size_t count, const SessionPlan& plan, RandomStream& chance);

  void advance(double duration, const Eigen::VectorXd& torques, RandomStream& chance); // [s], [Nm]
  const Eigen::VectorXd& degrees() const { return degrees_; }                          // Celsius

private:
  bool constant_, idle_;
  Eigen::VectorXd degrees_;
};

MotorTemperatures::MotorTemperatures(std::size_t count, const SessionPlan& plan, RandomStream& chance)
    : constant_{plan.sameTemperature}, idle_{plan.warmAnyhow}, degrees_{static_cast<Eigen::Index>(count)} {
  for (double& degrees : degrees_) {
    degrees = constant_ ? 38 : chance.between(28, 44);
  }
}

void MotorTemperatures::advance(double duration, const Eigen::VectorXd& torques, RandomStream& chance) {
  constexpr double slowness = 150, room = 30, heat = 3; // [s], [degrees Celsius], [K/(Nm)^2]
  const double share = 1 - std::exp(-duration / slowness);
  for (Eigen::Index i = 0; i < degrees_.size() && !constant_; ++i) {
    const double target = idle_ ? chance.between(-40, 130) : room + heat * torques[i] * torques[i];
    degrees_[i] += share * (target - degrees_[i]);
  }
}

class Stage {
public:
  Stage(const Robot& robot, const SessionPlan& plan, RandomStream& chance)
      : robot_{robot}, plan_{plan}, chance_{chance}, skeleton_{*robot.drawing, robot.flaws},
        motors_{robot.drawing->joints.size(), plan, chance} {}

  Session session(const std::vector<FloorPlace>& boards) {
    session_.boards = boards;
    session_.stances.push_back(stance(plan_.mainSide));
    if (plan_.bothSides) {
      session_.stances.push_back(stance(1 - plan_.mainSide));
    }
    drawPoses();
    time_ = chance_.between(3, 8);
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
      take(static_cast<int>(pose));
    }
    const TruePictures pictures{robot_, session_};
    session_.sights = findSights(pictures, session_);
    for (BoardSight& sight : session_.sights) {
      const double worse = plan_.noise.foreshortened ? slantFactor(pictures, session_, sight) : 1;
      sight.sigma = worse * plan_.noise.pixel;
    }
    return std::move(session_);
  }

private:
  Stance stance(int side) {
    const double halfWidth = robot_.drawing->lengths.at("hipY");
    return {side,
            {chance_.uniformWithin(0.02), (side == 0 ? 1 : -1) * halfWidth + chance_.uniformWithin(0.02),
             chance_.uniformWithin(0.1)}};
  }

  void drawPoses() {
    const PoseDrawer poses{*robot_.drawing, skeleton_};
    for (int pose = 0; pose < plan_.poses; ++pose) {
      const int stance = plan_.bothSides ? pose % 2 : 0;
      const int camera = (plan_.bothSides ? pose / 2 : pose) % 2; // alternates cameras, so that both are tested
      const auto worth = [&](const VectorXd& angles) {
        return cornersInView(skeleton_, session_.stances[stance], camera, session_.boards, angles);
      };
      constexpr double enough = 12; // corners
      VectorXd angles = poses.drawStable({.side = session_.stances[stance].side,
                                          .camera = camera,
                                          .targetsInSole = targets(session_.stances[stance]),
                                          .worth = worth,
                                          .enough = enough,
                                          .hipYawPitch = plan_.hipYawPitch},
                                         chance_);
      poses_.push_back({std::move(angles), stance});
    }
    if (plan_.sortedByKnee) {
      const int knee = robot_.drawing->joint(plan_.mainSide == 0 ? "LKneePitch" : "RKneePitch");
      std::sort(poses_.begin(), poses_.end(),
                [&](const Planned& a, const Planned& b) { return a.angles[knee] < b.angles[knee]; });
    } else {
      for (std::size_t i = poses_.size(); i > 1; --i) {
        std::swap(poses_[i - 1], poses_[chance_.below(static_cast<int>(i))]);
      }
    }
  }

  /// Centres of the boards in the sole's frame.
  std::vector<Eigen::Vector3d> targets(const Stance& stance) const {
    const Transform soleFromFloor = floorFromPlace(stance.place).inverse();
    std::vector<Eigen::Vector3d> middles;
    for (const FloorPlace& board : session_.boards) {
      middles.push_back(soleFromFloor *
                        (floorFromPlace(board) * sheetPoint({}, Sheet::squaresX / 2.0, Sheet::squaresY / 2.0)));
    }
    return middles;
  }

  /// Records all samples of a pose.
  void take(int pose) {
    const VectorXd& angles = poses_[pose].angles;
    const Index joints = angles.size();
    const VectorXd commanded = angles + robot_.offsets;
    VectorXd sticking{joints};
    for (Index i = 0; i < joints; ++i) {
      sticking[i] = chance_.uniformOfSigma(plan_.noise.stiction / std::sqrt(2.0));
    }
    pass(chance_.between(5, 14), angles, poses_[pose].stance);
    for (int repeat = 0; repeat < plan_.samples; ++repeat) {
      Reading reading;
      reading.pose = pose;
      reading.repeat = repeat;
      reading.stance = poses_[pose].stance;
      reading.kind = kindOf(pose, repeat);
      if (reading.kind == RepeatKind::restand) {
        session_.stances.push_back(stance(session_.stances[reading.stance].side));
        reading.stance = static_cast<int>(session_.stances.size()) - 1;
      }
      const bool moved = repeat == 0 || reading.kind != RepeatKind::rest;
      pass(moved ? chance_.between(2, 4) : 0.5, angles, reading.stance);
      reading.time = time_;
      reading.commanded = commanded;
      if (moved) {
        ++approaches_;
        approach(reading, sticking);
      } else {
        const Reading& before = session_.readings.back();
        reading.measured = calm_.measured;
        reading.unread = calm_.unread;
        reading.stuck = before.stuck;
        reading.excursion = before.excursion;
      }
      reading.approachNumber = approaches_;
      reading.velocity.resize(joints);
      for (double& velocity : reading.velocity) {
        velocity = chance_.normal(plan_.speed);
      }
      reading.temperature = motors_.degrees();
      calm_ = reading;
      jitter(reading);
      oneMotor(reading);
      session_.readings.push_back(std::move(reading));
    }
  }

  RepeatKind kindOf(int pose, int repeat) const {
    if (plan_.repeats) {
      return *plan_.repeats;
    }
    if (plan_.restands && repeat == plan_.samples - 1 && pose % 5 == 0 && repeat > 0) {
      return RepeatKind::restand;
    }
    return plan_.rests && repeat == 1 && pose % 3 == 0 ? RepeatKind::rest : RepeatKind::reapproach;
  }

  /// The servo stops within its dead zone, friction holds the link, and the encoder quantises the reading.
  void approach(Reading& reading, const VectorXd& sticking) {
    constexpr double deadZone = 0.0015, least = 0.08, most = 0.2; // [rad]
    const Index joints = reading.commanded.size();
    reading.measured.resize(joints);
    reading.unread.resize(joints);
    reading.stuck.resize(joints);
    reading.excursion.resize(joints);
    for (Index i = 0; i < joints; ++i) {
      const double stopped = reading.commanded[i] + chance_.uniformWithin(deadZone);
      const double noise = chance_.normal(encoderStep / std::sqrt(12.0));
      reading.measured[i] = plan_.noise.quantised ? std::round(stopped / encoderStep) * encoderStep : stopped + noise;
      reading.unread[i] = stopped - reading.measured[i];
      reading.stuck[i] = sticking[i] + chance_.uniformOfSigma(plan_.noise.stiction / std::sqrt(2.0));
      reading.excursion[i] = chance_.sign() * chance_.between(least, most);
    }
    if (plan_.sameApproach) {
      reading.excursion[*plan_.sameApproach] = -std::abs(reading.excursion[*plan_.sameApproach]);
    }
  }

  /// Adds reading jitter of a motor that stands still.
  void jitter(Reading& reading) {
    for (Index i = 0; plan_.noise.jitter > 0 && i < reading.measured.size(); ++i) {
      const double stands = reading.measured[i] + reading.unread[i];
      const double shown = (plan_.noise.quantised ? stands : reading.measured[i]) + chance_.normal(plan_.noise.jitter);
      reading.measured[i] = plan_.noise.quantised ? std::round(shown / encoderStep) * encoderStep : shown;
      reading.unread[i] = stands - reading.measured[i];
    }
  }

  /// Both hip yaw-pitch joints share one motor and encoder.
  void oneMotor(Reading& reading) const {
    const auto& joints = robot_.drawing->joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (!joints[i].drivenBy.empty()) {
        const int motor = robot_.drawing->joint(joints[i].drivenBy);
        for (VectorXd* list : {&reading.measured, &reading.unread, &reading.stuck, &reading.excursion,
                               &reading.velocity, &reading.temperature}) {
          (*list)[static_cast<Index>(i)] = (*list)[motor];
        }
      }
    }
  }

  /// Advances time and temperatures at a posture.
  void pass(double duration, const VectorXd& angles, int stance) {
    time_ += duration;
    const int side = session_.stances[stance].side;
    const Skeleton::Posture posture = skeleton_.posture(angles);
    motors_.advance(duration, skeleton_.torques(posture, side, skeleton_.torsoFromSole(posture, side).turn.col(2)),
                    chance_);
  }

  struct Planned {
    VectorXd angles;
    int stance;
  };

  const Robot& robot_;
  const SessionPlan& plan_;
  RandomStream& chance_;
  Skeleton skeleton_;
  Session session_;
  std::vector<Planned> poses_;
  MotorTemperatures motors_;
  double time_ = 0;
  int approaches_ = 0;
  Reading calm_; // last reading without jitter
};

} // namespace

Session stageSession(const Robot& robot, const SessionPlan& plan, const std::vector<FloorPlace>& boards,
                     RandomStream& chance) {
  return Stage{robot, plan, chance}.session(boards);
}

} // namespace blind

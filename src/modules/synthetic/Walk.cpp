#include "synthetic/Walk.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

using namespace std::chrono_literals;

std::vector<double> list(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

/// The robot on its way: where it stands, what it did last, how warm it is.
class Walker {
public:
  Walker(const SyntheticRobot& robot, const SimulationPlan& plan, const std::vector<Placement>& boards,
         std::uint64_t seed)
      : robot_{robot}, plan_{plan}, stanceChance_{seed, "stances"}, motion_{seed, "motion"}, sensors_{seed, "sensors"} {
    const auto joints = static_cast<Eigen::Index>(robot.drawing().joints.size());
    commanded_ = approach_ = Eigen::VectorXd::Zero(joints);
    temperatures_ = Eigen::VectorXd::Constant(joints, plan.mechanics.ambientTemperature);
    for (const Placement& board : boards) {
      worldFromBoard_.push_back(isometry(board));
    }
    for (std::size_t pose = 0; pose < plan.poses.size(); ++pose) {
      poseDeflections_.push_back(robot.scatter(plan.mechanics.poseScatter, motion_));
    }
  }

  Walk run() {
    const bool restands = plan_.repeatKind == RepeatKind::restand;
    for (int round = 0; round < (restands ? plan_.samples : 1); ++round) {
      stance_ = {};
      for (std::size_t pose = 0; pose < plan_.poses.size(); ++pose) {
        standOn(plan_.poses[pose].supportFoot);
        if (restands) {
          comeTo(pose, 3s);
          record(plan_.poses[pose], round);
        } else {
          takePose(pose);
        }
      }
    }
    return std::move(walk_);
  }

private:
  void takePose(std::size_t pose) {
    for (int repeat = 0; repeat < plan_.samples; ++repeat) {
      if (repeat == 0 || plan_.repeatKind == RepeatKind::reapproach) {
        comeTo(pose, 3s);
      } else {
        wait(0.4s);
      }
      record(plan_.poses[pose], repeat);
    }
  }

  /// Poses on one foot that follow each other share a stance.
  void standOn(SupportFoot foot) {
    if (stance_ && stance_->supportFoot == foot) {
      return;
    }
    const double y = foot == SupportFoot::right ? -halfStance : halfStance;
    stance_ = Stance{plan_.firstStance + static_cast<int>(walk_.stances.size()), foot, Placement{}};
    Placement& placement = *stance_->placement;
    placement.x = stanceChance_.within(plan_.stanceShiftRange);
    placement.y = y + stanceChance_.within(plan_.stanceShiftRange);
    placement.yaw = stanceChance_.within(plan_.stanceTurnRange);
    walk_.stances.push_back(*stance_);
    wait(20s);
  }

  void comeTo(std::size_t pose, Seconds duration) {
    const CommandedPose& target = plan_.poses[pose];
    Eigen::VectorXd commanded = target.angles;
    for (std::size_t joint = 0; joint < robot_.drawing().joints.size(); ++joint) {
      const auto motor = static_cast<Eigen::Index>(robot_.drawing().joints[joint].motor);
      commanded[static_cast<Eigen::Index>(joint)] = target.angles[motor];
    }
    for (Eigen::Index joint = 0; joint < commanded.size(); ++joint) {
      const double way = commanded[joint] - commanded_[joint];
      const double asked = target.approach.size() > 0 ? target.approach[joint] : 0;
      approach_[joint] = asked != 0 ? asked : way == 0 ? approach_[joint] : std::copysign(1, way);
    }
    commanded_ = commanded;
    taken_ = robot_.approach(commanded, approach_, target.supportFoot, poseDeflections_[pose], motion_);
    wait(duration);
  }

  void wait(Seconds duration) {
    time_ += duration;
    if (taken_) {
      robot_.warm(temperatures_, taken_->torques, duration);
    }
  }

  void record(const CommandedPose& pose, int repeat) {
    const Seconds start = time_;
    const std::vector<CameraMount>& cameras = robot_.drawing().cameras;
    for (std::size_t camera = 0; camera < cameras.size(); ++camera) {
      Capture capture;
      capture.id = static_cast<int>(walk_.captures.size());
      capture.pose = pose.name;
      capture.repeat = repeat;
      capture.repeatKind = plan_.repeatKind;
      capture.time = time_;
      capture.camera = cameras[camera].name;
      capture.supportFoot = pose.supportFoot;
      capture.stance = stance_->id;
      expose(capture, camera, time_ - start);
      wait(0.03s);
    }
  }

  void expose(Capture& capture, std::size_t camera, Seconds since) {
    Exposure exposure{robot_.jointAngles(*taken_, since), {}, worldFromBoard_};
    const Eigen::Isometry3d worldFromTorso =
        isometry(*stance_->placement) * robot_.soleFromTorso(exposure.joints, capture.supportFoot);
    exposure.worldFromCamera = worldFromTorso * robot_.torsoFromCamera(camera, exposure.joints);
    capture.joints = {list(robot_.encoderReadings(*taken_, since, sensors_)),
                      list(commanded_),
                      list(taken_->velocity),
                      list(approach_),
                      list(temperatures_),
                      list(robot_.currentReadings(*taken_, sensors_))};
    capture.imu = robot_.imuReading(worldFromTorso.linear(), sensors_);
    capture.fsr = robot_.forceReadings(*taken_, sensors_);
    walk_.captures.push_back(std::move(capture));
    walk_.exposures.push_back(std::move(exposure));
  }

  const SyntheticRobot& robot_;
  const SimulationPlan& plan_;
  Randomness stanceChance_, motion_, sensors_;
  std::vector<Eigen::Isometry3d> worldFromBoard_;
  std::vector<Eigen::VectorXd> poseDeflections_;
  Eigen::VectorXd commanded_, approach_, temperatures_;
  std::optional<Stance> stance_;
  std::optional<TakenPose> taken_;
  Seconds time_{0};
  Walk walk_;
};

} // namespace

Walk walk(const SyntheticRobot& robot, const SimulationPlan& plan, const std::vector<Placement>& boards,
          std::uint64_t seed) {
  return Walker{robot, plan, boards, seed}.run();
}

} // namespace naocal

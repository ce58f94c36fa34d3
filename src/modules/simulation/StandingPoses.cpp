#include "simulation/StandingPoses.hpp"

#include "io/InputError.hpp"
#include "math/RigidTransform.hpp"
#include "poses/candidates/PoseSampler.hpp"
#include "robot/LegKinematics.hpp"
#include "simulation/SyntheticRobot.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

std::vector<Eigen::VectorXd> oneFootPoses(const Robot& robot, const SimulationPlan& plan, SupportFoot supportFoot,
                                          std::size_t count, std::uint64_t seed) {
  PoseOptions options;
  options.supportFoot = supportFoot;
  options.count = count;
  options.seed = seed;
  std::vector<Board> boards = plan.boards;
  for (Board& board : boards) { // relative to the sole
    board.placement->y -= supportFoot == SupportFoot::left ? halfFootDistance : -halfFootDistance;
  }
  std::vector<Eigen::VectorXd> poses;
  for (PlannedPose& pose : planInformativePoses(robot, boards, plan.cameras, options)) {
    poses.push_back(std::move(pose.angles));
  }
  return poses;
}

/// Draws torso poses above two flat soles, and head directions.
class BothFeet {
public:
  BothFeet(const Robot& robot, const SimulationPlan& plan, std::uint64_t seed)
      : plan_{plan}, chance_{seed, "poses on both feet"},
        drawn_{robot,
               {Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size())),
                std::vector<RobotErrors::Mount>(robot.cameras.size())},
               {}},
        left_{robot, "left"}, right_{robot, "right"} {}

  /// Absent if the legs do not reach, a joint limit is exceeded, or no camera sees a board.
  std::optional<Eigen::VectorXd> pose() {
    const Robot& robot = drawn_.drawing();
    Eigen::VectorXd angles{static_cast<Eigen::Index>(robot.joints.size())};
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      const Joint& drawn = robot.joints[joint];
      angles[static_cast<Eigen::Index>(joint)] = std::clamp(drawn.restAngle, drawn.limits.lower, drawn.limits.upper);
    }
    set(angles, "HeadYaw", chance_.uniformWithin(1.2));
    set(angles, "HeadPitch", chance_.uniformWithin(0.4));
    const bool reached = bendLegs(angles);
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      const AngleRange limits = jointLimitsAt(robot, joint, angles);
      const double angle = angles[static_cast<Eigen::Index>(joint)];
      if (angle < limits.lower || angle > limits.upper) {
        return std::nullopt;
      }
    }
    return reached && seesABoard(angles) ? std::optional{angles} : std::nullopt;
  }

private:
  void set(Eigen::VectorXd& angles, const std::string& joint, double angle) {
    angles[static_cast<Eigen::Index>(*drawn_.drawing().jointIndex(joint))] = angle;
  }

  bool bendLegs(Eigen::VectorXd& angles) {
    constexpr double forwards = 0.02; // torso origin in front of the soles' frames [m]
    const RigidTransform floorFromTorso{
        rotationZ(chance_.uniformWithin(0.1)) * rotationY(0.1 + chance_.uniformWithin(0.3)) *
            rotationX(chance_.uniformWithin(0.1)),
        {forwards + chance_.uniformWithin(0.02), chance_.uniformWithin(0.02), 0.29 + chance_.uniformWithin(0.03)}};
    const double hipYawPitch = -0.15 + chance_.uniformWithin(0.15);
    for (const auto& [leg, y] : {std::pair{&left_, halfFootDistance}, {&right_, -halfFootDistance}}) {
      const RigidTransform floorFromSole{Eigen::Matrix3d::Identity(), {0, y, 0}};
      const auto bent = leg->solveAngles(floorFromTorso.inverse() * floorFromSole, hipYawPitch);
      if (!bent) {
        return false;
      }
      for (std::size_t joint = 0; joint < bent->size(); ++joint) {
        angles[static_cast<Eigen::Index>(leg->joints()[joint])] = (*bent)[joint];
      }
    }
    return true;
  }

  bool seesABoard(const Eigen::VectorXd& angles) const {
    constexpr std::size_t enough = 8;
    const Eigen::Isometry3d floorFromTorso =
        Eigen::Translation3d{0, halfFootDistance, 0} * drawn_.soleFromTorso(angles, SupportFoot::both);
    const std::vector<CameraMount>& cameras = drawn_.drawing().cameras;
    for (std::size_t camera = 0; camera < cameras.size(); ++camera) {
      const Eigen::Isometry3d cameraFromFloor = (floorFromTorso * drawn_.torsoFromCamera(camera, angles)).inverse();
      for (const Board& board : plan_.boards) {
        const BoardCorners seen = visibleCorners(plan_.cameras.at(cameras[camera].name), board,
                                                 cameraFromFloor * isometryFromPlacement(*board.placement));
        if (seen.ids.size() >= enough) {
          return true;
        }
      }
    }
    return false;
  }

  const SimulationPlan& plan_;
  RandomStream chance_;
  SyntheticRobot drawn_; // without errors
  LegKinematics left_, right_;
};

std::vector<Eigen::VectorXd> bothFeetPoses(const Robot& robot, const SimulationPlan& plan, std::size_t count,
                                           std::uint64_t seed) {
  BothFeet feet{robot, plan, seed};
  std::vector<Eigen::VectorXd> poses;
  for (std::size_t tries = 0; tries < 1000 * count && poses.size() < count; ++tries) {
    if (auto pose = feet.pose()) {
      poses.push_back(std::move(*pose));
    }
  }
  if (poses.size() < count) {
    throw InputError{
        fmt::format("only {} of {} poses on both feet see a board; lay the boards nearer", poses.size(), count)};
  }
  return poses;
}

} // namespace

std::vector<CommandedPose> planStandingPoses(const Robot& robot, const SimulationPlan& plan, SupportFoot supportFoot,
                                             std::size_t count, std::uint64_t seed) {
  const std::vector<Eigen::VectorXd> angles = supportFoot == SupportFoot::both
                                                  ? bothFeetPoses(robot, plan, count, seed)
                                                  : oneFootPoses(robot, plan, supportFoot, count, seed);
  std::vector<CommandedPose> poses;
  for (const Eigen::VectorXd& pose : angles) {
    poses.push_back({fmt::format("P{:02}", poses.size()), supportFoot, pose});
  }
  return poses;
}

} // namespace naocal

#include "brain/CalibrationScript.hpp"

#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace naocal {
namespace {

const char* nameOf(SupportFoot foot) {
  return foot == SupportFoot::left ? "left" : "right";
}

std::string takeHold(const std::string& why) {
  return fmt::format("The robot {} and may fall: take it by its trunk, and confirm. Hold it as long as its eyes are "
                     "yellow.",
                     why);
}

Eigen::VectorXd drawn(const Robot& drawing, const CompensatedAngles& stand) {
  Eigen::VectorXd angles{eigenIndex(drawing.joints.size())};
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    angles[eigenIndex(joint)] = stand[jointIndex(drawing.joints[joint].name).value()];
  }
  return angles;
}

} // namespace

CompensatedAngles turnHead(const CompensatedAngles& stand, double yaw, double pitch) {
  CompensatedAngles pose = stand;
  pose[*jointIndex("HeadYaw")] = radians(yaw);
  pose[*jointIndex("HeadPitch")] = radians(pitch);
  return pose;
}

CalibrationRound planHeadRound(const CompensatedAngles& stand, const std::vector<double>& yaws,
                               const std::vector<double>& pitches, double share, const RoundOptions& options) {
  std::vector<std::pair<double, double>> looks;
  for (const double pitch : pitches) {
    for (const double yaw : yaws) {
      looks.emplace_back(share * yaw, share * pitch);
    }
  }
  std::mt19937_64 random{options.seed};
  std::shuffle(looks.begin(), looks.end(), random);
  const std::size_t neck[]{*jointIndex("HeadYaw"), *jointIndex("HeadPitch")};
  CalibrationRound round;
  for (std::size_t look = 0; look < looks.size(); ++look) {
    const std::string id = fmt::format("H{:02}", look);
    for (int repeat = 0; repeat < options.pictures; ++repeat) {
      const CompensatedAngles pose = turnHead(stand, looks[look].first, looks[look].second);
      CalibrationStep step{fmt::format("Pose {}", id), "", false, {pose, pose}, 1, {}};
      step.taken.pose = id;
      step.taken.repeat = repeat;
      step.taken.repeatKind = RepeatKind::reapproach;
      step.taken.supportFoot = SupportFoot::both;
      step.taken.joints.approach.assign(jointCount, 0);
      for (const std::size_t joint : neck) {
        const double side = repeat % 2 == 0 ? 1 : -1; // direction of the final motion
        step.taken.joints.approach[joint] = side;
        step.points.front()[joint] -= side * options.approach;
      }
      round.push_back(std::move(step));
    }
  }
  round.push_back({"The stand", "", false, {}, 0, {}});
  return round;
}

LegRoundPlanner::LegRoundPlanner(const Robot& drawing, const PoseFile& file, SupportFoot foot,
                                 const CompensatedAngles& stand)
    : drawing_{drawing}, foot_{foot}, ways_{drawing, foot, drawn(drawing, stand),
                                            std::min(file.jointError, PoseOptions{}.stability.jointError)} {
  std::copy_if(file.poses.begin(), file.poses.end(), std::back_inserter(poses_),
               [&](const PlayablePose& pose) { return pose.supportFoot == foot; });
  if (poses_.empty()) {
    throw InputError{fmt::format("expected poses on the {} foot, found none", nameOf(foot))};
  }
}

SingleSupportPlanner::Approach LegRoundPlanner::approach(const PlayablePose& pose, double distance,
                                                         std::mt19937_64& random) const {
  auto found = ways_.planApproach(pose.angles, pose.approach, distance, random);
  if (!found) {
    throw InputError{fmt::format("pose {}: there is no safe way to it from standing upright on the {} foot; plan other "
                                 "poses with 'naocal poses'",
                                 pose.id, nameOf(foot_))};
  }
  return *std::move(found);
}

CompensatedAngles LegRoundPlanner::robotAngles(const Eigen::VectorXd& angles) const {
  CompensatedAngles result;
  for (std::size_t joint = 0; joint < drawing_.joints.size(); ++joint) {
    result[jointIndex(drawing_.joints[joint].name).value()] = angles[eigenIndex(joint)];
  }
  return result;
}

CalibrationRound LegRoundPlanner::onto(bool isHeld) const {
  const std::string foot = nameOf(foot_), name = fmt::format("The {} foot", foot);
  std::vector<CompensatedAngles> points;
  for (const Eigen::VectorXd& angles : ways_.pathOnto()) {
    points.push_back(robotAngles(angles));
  }
  const std::string letGo =
      fmt::format("Put the robot down so that its {} sole lies flat, let go, keep your hands around "
                  "it without touching it, and confirm.",
                  foot);
  return {{name, isHeld ? "" : takeHold(fmt::format("is going to stand on its {} foot", foot)), true, points, 0, {}},
          {name, letGo, false, {points.back()}, 0, {}}};
}

CalibrationRound LegRoundPlanner::planRound(const RoundOptions& options, int stance) const {
  std::mt19937_64 random{options.seed};
  std::vector<PlayablePose> poses = poses_;
  std::shuffle(poses.begin(), poses.end(), random);
  poses.resize(options.poses == 0 ? poses.size() : std::min(options.poses, poses.size()));
  CalibrationRound round = onto(stance > 0);
  std::vector<CompensatedAngles> back = {round.back().points.back()}; // way back to upright from the previous pose
  for (const PlayablePose& pose : poses) {
    const SingleSupportPlanner::Approach first = approach(pose, options.approach, random);
    for (int repeat = 0; repeat < options.pictures; ++repeat) {
      const Eigen::VectorXd side = repeat % 2 == 0 ? first.side : -first.side;
      CalibrationStep step{fmt::format("Pose {}", pose.id), "", false, {}, 1, {}};
      if (repeat == 0) {
        step.points = std::move(back);
        back.clear();
        std::transform(first.way.rbegin(), first.way.rend(), std::back_inserter(back),
                       [this](const Eigen::VectorXd& angles) { return robotAngles(angles); });
        back.push_back(robotAngles(ways_.pathOnto().back()));
        std::transform(first.way.begin(), first.way.end(), std::back_inserter(step.points),
                       [this](const Eigen::VectorXd& angles) { return robotAngles(angles); });
      } else {
        step.points = {robotAngles(pose.angles - options.approach * side)};
      }
      step.points.push_back(robotAngles(pose.angles));
      step.taken.pose = pose.id;
      step.taken.repeat = repeat;
      step.taken.repeatKind = RepeatKind::reapproach;
      step.taken.supportFoot = foot_;
      step.taken.stance = stance;
      const CompensatedAngles approaches = robotAngles(side);
      step.taken.joints.approach.assign(approaches.values.begin(), approaches.values.end());
      round.push_back(std::move(step));
    }
  }
  round.push_back({"The stand", takeHold("is going back onto both feet"), true, {}, 0, {}});
  return round;
}

} // namespace naocal

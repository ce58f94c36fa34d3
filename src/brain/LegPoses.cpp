#include "brain/LegPoses.hpp"

#include "captures/InputError.hpp"
#include "geometry/Index.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace naocal {
namespace {

const char* nameOf(SupportFoot foot) {
  return foot == SupportFoot::left ? "left" : "right";
}

PoseOptions onFoot(SupportFoot foot) {
  PoseOptions options;
  options.supportFoot = foot;
  return options;
}

/// Legs and head: what is between a sole and a camera.
bool isCalibrated(const std::string& joint) {
  return joint.starts_with("Head") || joint.find("Hip") != std::string::npos ||
         joint.find("Knee") != std::string::npos || joint.find("Ankle") != std::string::npos;
}

} // namespace

LegPoses::LegPoses(const Robot& drawing, const PoseFile& file, SupportFoot foot, const CompensatedAngles& stand)
    : drawing_{drawing}, foot_{foot}, options_{onFoot(foot)}, ways_{drawing, options_} {
  Eigen::VectorXd angles{at(drawing.joints.size())};
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    angles[at(joint)] = stand[jointNumber(drawing.joints[joint].name).value()];
  }
  ontoFoot_ = ontoOneFoot(drawing, foot, angles);
  std::copy_if(file.poses.begin(), file.poses.end(), std::back_inserter(poses_),
               [&](const PlayablePose& pose) { return pose.supportFoot == foot; });
  if (poses_.empty()) {
    throw InputError{fmt::format("expected poses on the {} foot, found none", nameOf(foot))};
  }
}

std::optional<LegPoses::Way> LegPoses::safeWay(const Eigen::VectorXd& to) const {
  for (const int parts : {1, 2, 4, 8}) {
    auto way = betweenOnOneFoot(drawing_, foot_, ontoFoot_.back(), to, parts);
    if (!way) {
      continue;
    }
    way->push_back(to);
    const Eigen::VectorXd* last = &ontoFoot_.back();
    const bool safe = std::all_of(way->begin(), way->end(), [&](const Eigen::VectorXd& point) {
      return ways_.seconds(*std::exchange(last, &point), point).has_value();
    });
    if (safe) {
      return way;
    }
  }
  return std::nullopt;
}

LegPoses::Approach LegPoses::approach(const PlayablePose& pose, double distance, std::mt19937_64& random) const {
  constexpr int tries = 16;
  Approach result{Eigen::VectorXd::Zero(pose.angles.size()), {}};
  for (int attempt = 0; attempt < tries; ++attempt) {
    for (std::size_t joint = 0; joint < drawing_.joints.size(); ++joint) {
      const double side = random() % 2 == 0 ? 1 : -1;
      result.side[at(joint)] = !isCalibrated(drawing_.joints[joint].name) ? 0
                               : pose.approach[at(joint)] != 0            ? pose.approach[at(joint)]
                                                                          : side;
      if (const std::size_t motor = drawing_.joints[joint].motor; motor != joint) {
        result.side[at(joint)] = result.side[at(motor)];
      }
    }
    const Eigen::VectorXd below = pose.angles - distance * result.side, above = pose.angles + distance * result.side;
    if (!ways_.seconds(below, pose.angles) || !ways_.seconds(pose.angles, above)) {
      continue;
    }
    if (auto way = safeWay(below)) {
      result.way = std::move(*way);
      return result;
    }
  }
  throw InputError{fmt::format("pose {}: there is no safe way to it from standing upright on the {} foot; plan other "
                               "poses with 'naocal poses'",
                               pose.id, nameOf(foot_))};
}

CompensatedAngles LegPoses::robotAngles(const Eigen::VectorXd& angles) const {
  CompensatedAngles result;
  for (std::size_t joint = 0; joint < drawing_.joints.size(); ++joint) {
    result[jointNumber(drawing_.joints[joint].name).value()] = angles[at(joint)];
  }
  return result;
}

CalibrationRound LegPoses::round(const RoundOptions& options, int stance) const {
  std::mt19937_64 random{options.seed};
  std::vector<PlayablePose> poses = poses_;
  std::shuffle(poses.begin(), poses.end(), random);
  poses.resize(options.poses == 0 ? poses.size() : std::min(options.poses, poses.size()));
  CalibrationRound round;
  CalibrationStep onto{fmt::format("The {} foot", nameOf(foot_)),
                       fmt::format("The robot is going to stand on its {} foot. Put your hands around it without "
                                   "touching it, and confirm.",
                                   nameOf(foot_)),
                       {},
                       0,
                       {}};
  for (const Eigen::VectorXd& angles : ontoFoot_) {
    onto.points.push_back(robotAngles(angles));
  }
  std::vector<CompensatedAngles> back = {onto.points.back()}; // upright again, from the pose before
  round.push_back(std::move(onto));
  for (const PlayablePose& pose : poses) {
    const Approach first = approach(pose, options.approach, random);
    for (int repeat = 0; repeat < options.pictures; ++repeat) {
      const Eigen::VectorXd side = repeat % 2 == 0 ? first.side : -first.side;
      CalibrationStep step{fmt::format("Pose {}", pose.id), "", {}, 1, {}};
      if (repeat == 0) {
        step.points = std::move(back);
        back.clear();
        std::transform(first.way.rbegin(), first.way.rend(), std::back_inserter(back),
                       [this](const Eigen::VectorXd& angles) { return robotAngles(angles); });
        back.push_back(robotAngles(ontoFoot_.back()));
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
  round.push_back({"The stand", "", {}, 0, {}});
  return round;
}

} // namespace naocal

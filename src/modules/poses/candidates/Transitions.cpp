#include "poses/candidates/Transitions.hpp"

#include "math/Parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace naocal {

namespace {

using Ways = std::vector<std::vector<std::optional<double>>>;
constexpr double never = std::numeric_limits<double>::infinity();

std::vector<std::size_t> nearestNext(const Ways& seconds) {
  std::vector<std::size_t> order{0};
  while (order.size() < seconds.size()) {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
      const auto& way = seconds[order.back()][i];
      if (way && std::find(order.begin(), order.end(), i) == order.end() &&
          (!next || *way < *seconds[order.back()][*next])) {
        next = i;
      }
    }
    if (!next) {
      break;
    }
    order.push_back(*next);
  }
  return order;
}

/// Held and Karp (1962): the quickest path through each subset of poses ending at each member.
std::vector<std::size_t> byDynamicProgramming(const Ways& seconds) {
  const std::size_t count = seconds.size(), sets = std::size_t{1} << count;
  std::vector<std::vector<double>> shortest(sets, std::vector<double>(count, never));
  std::vector<std::vector<std::size_t>> before(sets, std::vector<std::size_t>(count, count));
  for (std::size_t i = 0; i < count; ++i) {
    shortest[std::size_t{1} << i][i] = 0;
  }
  for (std::size_t set = 1; set < sets; ++set) {
    for (std::size_t last = 0; last < count; ++last) {
      for (std::size_t next = 0; next < count && shortest[set][last] < never; ++next) {
        const std::size_t larger = set | std::size_t{1} << next;
        const double length = larger == set ? never : shortest[set][last] + seconds[last][next].value_or(never);
        if (length < shortest[larger][next]) {
          shortest[larger][next] = length;
          before[larger][next] = last;
        }
      }
    }
  }
  std::size_t set = sets - 1;
  auto last =
      static_cast<std::size_t>(std::min_element(shortest[set].begin(), shortest[set].end()) - shortest[set].begin());
  std::vector<std::size_t> order;
  while (last < count && shortest[set][last] < never) {
    order.insert(order.begin(), last);
    const std::size_t previous = before[set][last];
    set &= ~(std::size_t{1} << last);
    last = previous;
  }
  return order;
}

PoseOptions onTheWay(PoseOptions options, const TransitionOptions& motion) {
  options.footing = {.depth = 0.01, .clearance = 0.005};
  options.stability.share = motion.share;
  return options;
}

/// Direct motion if safe; otherwise along the line between the poses' points in the sampling ranges, which keeps the
/// centre of mass above the foot. Absent if neither is safe.
std::optional<Transition> findTransition(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                                         const TransitionCheck& checks, const ValidPose& from, const ValidPose& to) {
  const auto joints = static_cast<Eigen::Index>(robot.joints.size());
  const Eigen::VectorXd start = from.modelState.values.head(joints), end = to.modelState.values.head(joints);
  if (const auto straight = checks.duration(start, end)) {
    return Transition{{}, *straight};
  }
  PoseSampler attitudes{robot, scene, options};
  for (const int parts : {2, 4, 8}) {
    Transition way;
    Eigen::VectorXd last = start;
    for (int i = 1; i <= parts; ++i) {
      std::vector<double> point(from.point.size());
      for (std::size_t k = 0; k < point.size(); ++k) {
        point[k] = from.point[k] + (to.point[k] - from.point[k]) * i / parts;
      }
      const auto reached = i == parts ? std::optional{to.modelState} : attitudes.stateAt(point);
      const auto seconds = reached ? checks.duration(last, reached->values.head(joints)) : std::nullopt;
      if (!seconds) {
        break;
      }
      last = reached->values.head(joints);
      way.seconds += *seconds;
      if (i == parts) {
        return way;
      }
      way.via.push_back(last);
    }
  }
  return std::nullopt;
}

} // namespace

double motionTime(const Robot& robot, const Eigen::VectorXd& from, const Eigen::VectorXd& to, double speed) {
  double seconds = 0;
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto i = static_cast<Eigen::Index>(joint);
    if (robot.joints[joint].maxSpeed > 0) {
      seconds = std::max(seconds, std::abs(to[i] - from[i]) / (speed * robot.joints[joint].maxSpeed));
    }
  }
  return seconds;
}

TransitionCheck::TransitionCheck(const Robot& robot, const PoseOptions& options, const TransitionOptions& motion)
    : robot_{robot}, motion_{motion}, options_{onTheWay(options, motion)}, checks_{robot, options_} {}

std::optional<double> TransitionCheck::duration(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const {
  std::mt19937_64 random{options_.seed};
  const LinkPoses before = forwardKinematics(robot_, from);
  if (isSliding(before, forwardKinematics(robot_, to))) {
    return std::nullopt;
  }
  ModelState modelState = nominalState(robot_, StateLayout{robot_.joints.size(), robot_.lengths.size(), 0});
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).cwiseAbs().maxCoeff() / motion_.step)));
  for (int i = 1; i < steps; ++i) {
    modelState.values.head(from.size()) = from + (to - from) * i / steps;
    const LinkPoses torsoFromLink = forwardKinematics(robot_, modelState);
    if (isSliding(before, torsoFromLink) || checks_.selfCollides(torsoFromLink) ||
        !checks_.balancedFraction(modelState, torsoFromLink, random)) {
      return std::nullopt;
    }
  }
  return motionTime(robot_, from, to, motion_.speed);
}

/// On both feet: whether a corner of the other sole moves by more than `slip` relative to the support sole.
bool TransitionCheck::isSliding(const LinkPoses& before, const LinkPoses& now) const {
  if (options_.supportFoot != SupportFoot::both) {
    return false;
  }
  const Sole &support = checks_.support(), &other = checks_.other();
  const RigidTransform then = before[support.link].inverse() * before[other.link],
                       there = now[support.link].inverse() * now[other.link];
  return std::any_of(other.outline.begin(), other.outline.end(), [&](const Eigen::Vector2d& corner) {
    const Eigen::Vector3d point{corner.x(), corner.y(), 0};
    return (then * point - there * point).norm() > motion_.slip;
  });
}

double playTime(const Robot& robot, const std::vector<ValidPose>& poses, double secondsPerPose) {
  const auto joints = static_cast<Eigen::Index>(robot.joints.size());
  const double speed = TransitionOptions{}.speed;
  Ways seconds(poses.size(), std::vector<std::optional<double>>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t k = 0; k < poses.size(); ++k) {
      seconds[i][k] =
          motionTime(robot, poses[i].modelState.values.head(joints), poses[k].modelState.values.head(joints), speed);
    }
  }
  double sum = secondsPerPose * static_cast<double>(poses.size());
  const std::vector<std::size_t> order = findQuickestOrder(seconds).value_or(std::vector<std::size_t>{});
  for (std::size_t i = 1; i < order.size(); ++i) {
    sum += *seconds[order[i - 1]][order[i]];
  }
  return sum;
}

std::optional<std::vector<std::size_t>> findQuickestOrder(const Ways& seconds) {
  constexpr std::size_t exact = 12;
  const std::vector<std::size_t> order = seconds.size() <= exact ? byDynamicProgramming(seconds) : nearestNext(seconds);
  return order.size() == seconds.size() ? std::optional{order} : std::nullopt;
}

OrderedPoses orderPoses(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                        std::vector<ValidPose> poses) {
  const std::size_t count = poses.size();
  const TransitionCheck checks{robot, options};
  std::vector<std::optional<Transition>> ways(count * count);
  parallelFor(count * count, [&](std::size_t i) {
    ways[i] = findTransition(robot, scene, options, checks, poses[i / count], poses[i % count]);
  });
  std::vector<std::vector<std::optional<double>>> seconds(count, std::vector<std::optional<double>>(count));
  for (std::size_t i = 0; i < count * count; ++i) {
    if (ways[i]) {
      seconds[i / count][i % count] = ways[i]->seconds;
    }
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  order = findQuickestOrder(seconds).value_or(order);
  OrderedPoses result;
  for (std::size_t i = 0; i < count; ++i) {
    result.poses.push_back(std::move(poses[order[i]]));
    result.ways.push_back(i == 0 ? std::nullopt : ways[order[i - 1] * count + order[i]]);
  }
  return result;
}

} // namespace naocal

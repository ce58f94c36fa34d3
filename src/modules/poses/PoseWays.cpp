#include "poses/PoseWays.hpp"

#include "math/Parallel.hpp"

#include <numeric>

namespace naocal {

std::optional<PoseWay> safeWay(const Robot& robot, const Scene& scene, const PoseOptions& options,
                               const WayChecks& checks, const SievedPose& from, const SievedPose& to) {
  const auto joints = static_cast<Eigen::Index>(robot.joints.size());
  const Eigen::VectorXd start = from.belief.values.head(joints), end = to.belief.values.head(joints);
  if (const auto straight = checks.seconds(start, end)) {
    return PoseWay{{}, *straight};
  }
  RandomAttitude attitudes{robot, scene, options};
  for (const int parts : {2, 4, 8}) {
    PoseWay way;
    Eigen::VectorXd last = start;
    for (int i = 1; i <= parts; ++i) {
      std::vector<double> point(from.point.size());
      for (std::size_t k = 0; k < point.size(); ++k) {
        point[k] = from.point[k] + (to.point[k] - from.point[k]) * i / parts;
      }
      const auto reached = i == parts ? std::optional{to.belief} : attitudes.reached(point);
      const auto seconds = reached ? checks.seconds(last, reached->values.head(joints)) : std::nullopt;
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

PosesInOrder inOrder(const Robot& robot, const Scene& scene, const PoseOptions& options,
                     std::vector<SievedPose> poses) {
  const std::size_t count = poses.size();
  const WayChecks checks{robot, options};
  std::vector<std::optional<PoseWay>> ways(count * count);
  inParallel(count * count, [&](std::size_t i) {
    ways[i] = safeWay(robot, scene, options, checks, poses[i / count], poses[i % count]);
  });
  std::vector<std::vector<std::optional<double>>> seconds(count, std::vector<std::optional<double>>(count));
  for (std::size_t i = 0; i < count * count; ++i) {
    if (ways[i]) {
      seconds[i / count][i % count] = ways[i]->seconds;
    }
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  order = quickestOrder(seconds).value_or(order);
  PosesInOrder result;
  for (std::size_t i = 0; i < count; ++i) {
    result.poses.push_back(std::move(poses[order[i]]));
    result.ways.push_back(i == 0 ? std::nullopt : ways[order[i - 1] * count + order[i]]);
  }
  return result;
}

} // namespace naocal

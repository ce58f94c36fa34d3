#include "poses/PoseWays.hpp"

namespace naocal {

std::optional<PoseWay> safeWay(const Robot& robot, const Scene& scene, const PoseOptions& options,
                               const SievedPose& from, const SievedPose& to) {
  const auto joints = static_cast<Eigen::Index>(robot.joints.size());
  const Eigen::VectorXd start = from.belief.values.head(joints), end = to.belief.values.head(joints);
  if (const auto straight = secondsOnTheWay(robot, options, start, end)) {
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
      const auto seconds = reached ? secondsOnTheWay(robot, options, last, reached->values.head(joints)) : std::nullopt;
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

} // namespace naocal

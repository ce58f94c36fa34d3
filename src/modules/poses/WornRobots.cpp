#include "poses/WornRobots.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <random>

namespace naocal {

std::vector<Eigen::VectorXd> wornRobots(const Robot& robot, const PoseOptions& options, std::size_t count,
                                        std::uint64_t number) {
  std::seed_seq mixed{options.seed, number};
  std::mt19937_64 random{mixed};
  std::uniform_real_distribution<double> error{-options.stability.jointError, options.stability.jointError};
  std::vector<Eigen::VectorXd> result(count, Eigen::VectorXd(at(robot.joints.size())));
  for (Eigen::VectorXd& errors : result) {
    std::generate(errors.begin(), errors.end(), [&] { return error(random); });
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      errors[at(joint)] = errors[at(robot.joints[joint].motor)];
    }
  }
  return result;
}

std::vector<SievedPose> takenBy(const Eigen::VectorXd& errors, std::vector<SievedPose> poses) {
  for (SievedPose& pose : poses) {
    pose.belief.values.head(errors.size()) += errors;
  }
  return poses;
}

} // namespace naocal

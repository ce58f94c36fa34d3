#include "poses/ThesisSelection.hpp"

#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"

namespace naocal {

namespace {

Eigen::VectorXd jointWeights(const Robot& robot, const std::vector<std::size_t>& joints,
                             const std::map<std::string, double>& weights) {
  Eigen::VectorXd result = Eigen::VectorXd::Ones(at(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (const auto weight = weights.find(robot.joints[joints[i]].name); weight != weights.end()) {
      result[at(i)] = weight->second;
    }
  }
  return result;
}

} // namespace

ThesisSelection::ThesisSelection(const Robot& robot, const Sole& support,
                                 const std::map<std::string, CameraIntrinsics>& cameras,
                                 const std::vector<std::size_t>& joints, const std::map<std::string, double>& weights)
    : sensor_{robot, support, cameras, joints, weights}, judge_{jointWeights(robot, joints, weights)},
      angles_{at(robot.joints.size())} {}

std::vector<Eigen::ArrayXd> ThesisSelection::interactions(const std::vector<SievedPose>& poses) const {
  std::vector<Eigen::ArrayXd> result(poses.size());
  inParallel(poses.size(), [&](std::size_t i) {
    result[i] = jointInteraction(sensor_.observation(poses[i].belief.values.head(angles_)));
  });
  return result;
}

Interaction ThesisSelection::interaction(const std::vector<SievedPose>& poses) const {
  const std::vector<Eigen::ArrayXd> all = interactions(poses);
  Eigen::ArrayXd product = all.front();
  for (std::size_t i = 1; i < all.size(); ++i) {
    product *= all[i];
  }
  return judge_(product);
}

std::vector<std::size_t> ThesisSelection::chain(const std::vector<SievedPose>& poses, std::size_t count) const {
  return judge_.chain(interactions(poses), count);
}

} // namespace naocal

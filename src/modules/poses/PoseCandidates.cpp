#include "poses/PoseCandidates.hpp"

#include "math/Parallel.hpp"

#include <Eigen/Cholesky>
#include <mutex>

namespace naocal {

namespace {

constexpr std::size_t chunk = 5000; // attitudes

/// J^T (R + J_t s^2 J_t^T)^-1 J of J^T R^-1 J, by Woodbury: an offset and the deflections of its joint have the same
/// columns.
Eigen::MatrixXd whitened(const Eigen::MatrixXd& gram, Eigen::Index joints, const Noise& noise) {
  const double deflection = noise.encoder * noise.encoder + noise.pose * noise.pose;
  const Eigen::MatrixXd byJoints = gram.leftCols(joints);
  Eigen::MatrixXd inner = byJoints.topRows(joints);
  inner.diagonal().array() += 1 / deflection;
  const Eigen::MatrixXd half = inner.llt().matrixL().solve(byJoints.transpose());
  return gram - half.transpose() * half;
}

} // namespace

PoseCandidates poseCandidates(const Robot& robot, const Scene& scene, const PoseOptions& options,
                              const std::function<void(std::size_t)>& progress) {
  const std::size_t chunks = (options.tries + chunk - 1) / chunk;
  std::vector<PoseCandidates> parts(chunks);
  std::mutex telling;
  std::size_t tried = 0;
  inParallel(chunks, [&](std::size_t i) {
    RandomAttitude attitudes{robot, scene, options, i * chunk};
    const std::size_t count = std::min(chunk, options.tries - i * chunk);
    for (std::size_t k = 0; k < count; ++k) {
      if (auto attitude = attitudes.draw(parts[i].sieve)) {
        parts[i].attitudes.push_back(*std::move(attitude));
      }
    }
    const std::lock_guard lock{telling};
    tried += count;
    if (progress) {
      progress(tried);
    }
  });
  PoseCandidates all;
  for (PoseCandidates& part : parts) {
    all.sieve += part.sieve;
    std::move(part.attitudes.begin(), part.attitudes.end(), std::back_inserter(all.attitudes));
  }
  return all;
}

std::vector<Eigen::MatrixXd> informations(const Robot& robot, const Scene& scene, const std::vector<SievedPose>& poses,
                                          const Noise& noise) {
  std::vector<Eigen::MatrixXd> result(poses.size());
  inParallel(poses.size(), [&](std::size_t i) {
    const auto joints = static_cast<Eigen::Index>(robot.joints.size());
    Belief belief = scene.drawn(); // the boards may lie elsewhere than when the pose was drawn
    belief.values.head(joints) = poses[i].belief.values.head(joints);
    result[i] = whitened(scene.information(belief, posture(robot, belief), noise.pixel), joints, noise);
  });
  return result;
}

} // namespace naocal

#include "diagnose/HeldOutSums.hpp"

#include <algorithm>

namespace naocal {

namespace {

constexpr std::size_t folds = 5;

HeldOutSums empty(Eigen::Index size) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(size, size);
  return {none, none, none.col(0), none.col(0)};
}

void add(const PoseSystem& pose, const Eliminated& part, HeldOutSums& sums) {
  sums.hessian(pose.unknowns, pose.unknowns) += part.hessian;
  sums.gradient(pose.unknowns) += part.unknownGradient;
  sums.gram(pose.unknowns, pose.unknowns) += pose.unknownGram;
  sums.plainGradient(pose.unknowns) += pose.unknownGradient;
  sums.squares += pose.squares;
  sums.numbers += pose.numbers;
}

void move(const Eigen::VectorXd& step, HeldOutSums& sums) {
  const Eigen::VectorXd moved = sums.gram * step;
  sums.squares += 2 * sums.plainGradient.dot(step) + step.dot(moved);
  sums.plainGradient += moved;
  sums.gradient += sums.hessian * step;
}

} // namespace

HeldOutParts heldOutSums(const Inquiry& inquiry, const Eigen::VectorXd& step) {
  const std::vector<PoseRows>& poses = inquiry.poses();
  const Noise noise = inquiry.noise();
  HeldOutParts result{empty(step.size()), {}};
  result.parts.resize(std::min(folds, poses.size()), result.all);
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    const PoseSystem system = systemOf(poses[pose]);
    const Eliminated part = eliminated(system, noise, deflectionRoot(system, noise));
    add(system, part, result.all);
    add(system, part, result.parts[pose % result.parts.size()]);
  }
  move(step, result.all);
  for (HeldOutSums& part : result.parts) {
    move(step, part);
  }
  return result;
}

} // namespace naocal

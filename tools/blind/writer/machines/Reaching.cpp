#include "writer/machines/Reaching.hpp"

#include <Eigen/Cholesky>

namespace blind {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::optional<VectorXd> reach(const Machine& machine, const MachineBody& body, VectorXd start, const Miss& miss) {
  constexpr double nudge = 1e-6, damping = 1e-4, closeEnough = 1e-7, longestStep = 0.5;
  VectorXd angles = std::move(start);
  for (int round = 0; round < 60; ++round) {
    const VectorXd missed = miss(body.settled(angles));
    if (missed.norm() < closeEnough) {
      for (Index i = 0; i < angles.size(); ++i) {
        const Machine::Joint& joint = machine.joints[static_cast<std::size_t>(i)];
        if (angles[i] < joint.lower || angles[i] > joint.upper) {
          return std::nullopt;
        }
      }
      return angles;
    }
    MatrixXd slopes{missed.size(), angles.size()};
    for (Index i = 0; i < angles.size(); ++i) {
      VectorXd nudged = angles;
      nudged[i] += nudge;
      slopes.col(i) = (miss(body.settled(nudged)) - missed) / nudge;
    }
    MatrixXd square = slopes * slopes.transpose();
    square.diagonal().array() += damping * missed.norm();
    VectorXd step = slopes.transpose() * square.ldlt().solve(missed);
    step *= std::min(1.0, longestStep / step.norm());
    angles -= step;
  }
  return std::nullopt;
}

VectorXd drawAngles(const Machine& machine, RandomStream& chance) {
  VectorXd angles{static_cast<Index>(machine.joints.size())};
  for (Index i = 0; i < angles.size(); ++i) {
    const Machine::Joint& joint = machine.joints[static_cast<std::size_t>(i)];
    angles[i] = chance.between(joint.lower, joint.upper);
  }
  return angles;
}

} // namespace blind

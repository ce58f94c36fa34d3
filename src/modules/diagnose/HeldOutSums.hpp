#pragma once

#include "diagnose/Inquiry.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Sums over some poses, of all columns of a linearised problem: whitened ones to learn from, plain ones to measure by.
struct HeldOutSums {
  Eigen::MatrixXd hessian, gram;
  Eigen::VectorXd gradient, plainGradient;
  double squares = 0, numbers = 0;
};

/// The sums of all poses, and of each of the five folds (or as many as there are poses), with the unknowns moved by
/// `step`.
struct HeldOutParts {
  HeldOutSums all;
  std::vector<HeldOutSums> parts;
};
HeldOutParts heldOutSums(const Inquiry& inquiry, const Eigen::VectorXd& step);

} // namespace naocal

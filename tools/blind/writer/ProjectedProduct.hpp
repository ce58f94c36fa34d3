#pragma once

#include <Eigen/Cholesky>
#include <vector>

namespace blind {

/// The rows of one pose, and what is random in them.
struct PoseNoise {
  std::vector<Eigen::Index> rows;
  Eigen::MatrixXd shared;  // by common random variables of unit variance, in units of the measurements
  Eigen::VectorXd weights; // 1 / sigma^2 of the measurements
};

/// Products of changes of all measurements for an observer who knows the noise but not the robot:
///
///   M Sigma^-1 = Sigma^-1 - Sigma^-1 A (A^T Sigma^-1 A + Lambda)^-1 A^T Sigma^-1
///
/// A: derivative of all measurements by what is unknown; Lambda: its prior information (`priorWeights`, 1 / sigma^2).
class ProjectedProduct {
public:
  ProjectedProduct(std::vector<PoseNoise> noise, Eigen::MatrixXd unknowns, const Eigen::VectorXd& priorWeights);

  /// d^T M Sigma^-1 d', the noncentrality if both are equal.
  double product(const Eigen::VectorXd& left, const Eigen::VectorXd& right) const;
  /// d^T Sigma^-1 d': the same for an observer who knows the robot.
  double knownProduct(const Eigen::VectorXd& left, const Eigen::VectorXd& right) const;

private:
  struct Block {
    PoseNoise noise;
    Eigen::LLT<Eigen::MatrixXd> inner; // 1 + shared^T weights shared
  };
  Eigen::MatrixXd whitened(const Eigen::MatrixXd& columns) const; // Sigma^-1 columns

  std::vector<Block> blocks_;
  Eigen::MatrixXd unknowns_;         // A
  Eigen::MatrixXd whitenedUnknowns_; // Sigma^-1 A
  Eigen::LLT<Eigen::MatrixXd> information_;
};

} // namespace blind

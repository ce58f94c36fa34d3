#pragma once

#include "world/Pictures.hpp"
#include "writer/SessionPlanner.hpp"
#include "writer/SetFile.hpp"

#include <Eigen/Cholesky>

namespace blind {

/// RMS error [px] of an ideal prediction that knows the robot with all its flaws and fits placements of boards and feet
/// by plain least squares (as a comparison does), but uses encoder readings with their errors and does not know
/// frictional deflections.
double noiseFloor(const Robot& robot, const Session& session, const ObservedCorners& seen);

/// Visibility of a change of the images to an observer who knows the noise but not the robot:
///
///   lambda = d^T M Sigma^-1 d,  M Sigma^-1 = Sigma^-1 - Sigma^-1 A (A^T Sigma^-1 A + Lambda)^-1 A^T Sigma^-1
///
/// A: derivative of all corners (finite differences) with respect to the offsets of the joints in use, the camera
/// rotations and the placements of all boards (except the first) and stances; Lambda: prior information on offsets and
/// cameras. Sigma: pixel noise, image shifts, encoder error and stiction per approach, stiction common to all
/// approaches of a pose.
class Noncentrality {
public:
  Noncentrality(const Robot& robot, const Session& session, const NoiseRegime& noise);

  /// All corners of all sights in one vector.
  static Eigen::VectorXd stacked(const TruePictures& pictures, const Session& session);

  /// M Sigma^-1 product of two image differences; the noncentrality if both are equal.
  double product(const Eigen::VectorXd& left, const Eigen::VectorXd& right) const;
  /// Sigma^-1 product: the same for an observer who knows the robot.
  double knownProduct(const Eigen::VectorXd& left, const Eigen::VectorXd& right) const;

private:
  struct Block { // the rows of one pose
    std::vector<Eigen::Index> rows;
    Eigen::MatrixXd shared;            // by common random variables of unit variance [px]
    Eigen::VectorXd weights;           // 1 / sigma^2 [1/px^2]
    Eigen::LLT<Eigen::MatrixXd> inner; // 1 + shared^T weights shared
  };
  Eigen::MatrixXd whitened(const Eigen::MatrixXd& columns) const; // Sigma^-1 columns

  std::vector<Block> blocks_;
  Eigen::MatrixXd unknowns_;         // A
  Eigen::MatrixXd whitenedUnknowns_; // Sigma^-1 A
  Eigen::LLT<Eigen::MatrixXd> information_;
};

} // namespace blind

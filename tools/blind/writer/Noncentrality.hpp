#pragma once

#include "writer/Pictures.hpp"
#include "writer/SessionPlanner.hpp"
#include "writer/SetFile.hpp"

#include <Eigen/Cholesky>

namespace blind {

/// How far corners lie from their predictions by someone who knows the robot with all its flaws, finds out by plain
/// least squares where boards and feet stand (as a comparison does), but reads the angles with the encoders' errors and
/// does not know where friction held the links: rms of distances [px].
double noiseFloor(const Robot& robot, const Session& session, const ObservedCorners& seen);

/// How visible a difference of pictures is to someone who knows the noise but not the robot:
///
///   lambda = d^T M Sigma^-1 d,  M Sigma^-1 = Sigma^-1 - Sigma^-1 A (A^T Sigma^-1 A + Lambda)^-1 A^T Sigma^-1
///
/// A: derivative of all corners (finite differences) by the offsets of the joints in use, the cameras' rotations and
/// the places of boards and stances but the first board's; Lambda: how far off offsets and cameras plausibly are.
/// Sigma: pixels, shifts of pictures, encoder and stiction of each approach, stiction that all approaches of a pose
/// share.
class Noncentrality {
public:
  Noncentrality(const Robot& robot, const Session& session, const NoiseRegime& noise);

  /// The corners of all sights below each other.
  static Eigen::VectorXd stacked(const TruePictures& pictures, const Session& session);

  /// M Sigma^-1 between two differences of pictures; their noncentrality when both are the same.
  double product(const Eigen::VectorXd& left, const Eigen::VectorXd& right) const;
  /// Sigma^-1 alone: the same to someone who knows the robot too.
  double knownProduct(const Eigen::VectorXd& left, const Eigen::VectorXd& right) const;

private:
  struct Block { // the rows of one pose
    std::vector<Eigen::Index> rows;
    Eigen::MatrixXd shared;            // by what is random in common, each of unit variance [px]
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

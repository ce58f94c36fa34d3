#pragma once

#include "estimation/NormalEquations.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

namespace naocal {

struct Noise;

/// The part of a linearised problem that belongs to one pose, in pixels and radians, before any noise level is applied.
///
/// Columns: the unknowns x that the pose depends on, and its joint deflections t (encoder error and anything else
/// between the true angle and the reading; one per joint and distinct encoder error), linearised at t = 0.
struct PosePart {
  std::vector<std::size_t> unknowns; // indices, ascending
  std::vector<std::size_t> joints;   // joint of each deflection; deflections of one joint are adjacent
  std::vector<std::size_t> errors;   // encoder error of each deflection, as an index into its pose's
  std::vector<double> errorScales;   // size of that encoder error relative to the noise level
  std::vector<std::size_t> stances;  // stance of each deflection
  double squares = 0;                // sum of w r^2, w the loss weight times `cornerShare`  [px^2]
  double loss = 0;                   // sum of rho, plus the cost of the pose's other measurements
  double numbers = 0; // scalar measurements: two shares per corner with weight > 0, three per sole, two per IMU reading
  double freedom = 0; // expectation of squares / pixel^2 under pixel noise alone
};

/// A pose's part as normal equations.
struct PoseSystem : PosePart {
  Eigen::MatrixXd unknownGram;        // sum of w J_x^T J_x      [px^2 / unknown^2]
  Eigen::MatrixXd jointErrorCross;    // sum of w J_x^T J_t
  Eigen::MatrixXd jointErrorGram;     // sum of w J_t^T J_t      [px^2 / rad^2]
  Eigen::VectorXd unknownGradient;    // sum of w J_x^T r
  Eigen::VectorXd jointErrorGradient; // sum of w J_t^T r
};

/// A pose's part as rows with the same products as all its weighted corners. A picture reduces to a handful of rows for
/// any number of unknowns, so memory does not grow quadratically.
struct PoseRows : PosePart {
  Eigen::MatrixXd byUnknowns;    // J_x  [px / unknown]
  Eigen::MatrixXd byDeflections; // J_t  [px / rad]
  Eigen::VectorXd residual;      // r    [px]
};

/// Normal equations of the rows.
PoseSystem systemOf(const PoseRows& rows);

/// t = root * z with z of unit covariance: root root^T = encoder^2 diag(scales^2) + reapproach^2 1 + pose^2 1 1^T
/// within a joint, and + stance^2 1 1^T within a joint and stance.
using JointErrorRoot = Eigen::SparseMatrix<double>;
JointErrorRoot jointErrorRoot(const PosePart& pose, const Noise& noise);

/// Accumulates the rows of one pose (`PoseRows`): per group of a picture, as many rows as its gram has rank.
class RowEquations {
public:
  void clear(Eigen::Index columns);

  /// Adds sums over L, the derivative with respect to the picture's motion (and extras): the rows are U C with U^T U =
  /// `gram`, C = motion * (the group's shares of the slopes' values), and their residuals U^-T `gradient`.
  void add(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
           const Eigen::MatrixXd& motion, const PreparedImage::Group& group, const double* slopeValues);

  /// Moves the rows into `rows`, whose unknowns and joints are set, re-expressed at zero deflection.
  void takeRows(const Eigen::VectorXd& deflections, PoseRows& rows) const;

private:
  Eigen::Index columns_ = 0;
  std::vector<Eigen::MatrixXd> parts_; // per group: its columns, then the residual
};

/// A pose with its deflections marginalised: Sigma = pixel^2 I + J_t S J_t^T, by the Woodbury identity on the
/// deflections.
struct MarginalSystem {
  Eigen::LLT<Eigen::MatrixXd> inner; // I + root^T jointErrorGram root / pixel^2 = L L^T
  Eigen::MatrixXd half;              // L^-1 root^T J_t^T [J_x r] / pixel^2
  Eigen::MatrixXd hessian;           // J_x^T Sigma^-1 J_x
  Eigen::VectorXd unknownGradient;   // J_x^T Sigma^-1 r
  double cost = 0;                   // r^T Sigma^-1 r / 2
};
MarginalSystem marginalize(const PoseSystem& pose, const Noise& noise, const JointErrorRoot& root);
/// As above, reusing the memory of `result`.
void marginalize(const PoseSystem& pose, const Noise& noise, const JointErrorRoot& root, MarginalSystem& result);

} // namespace naocal

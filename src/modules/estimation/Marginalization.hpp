#pragma once

#include "estimation/NormalEquations.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

namespace naocal {

struct Noise;

/// One pose's part of a linearised problem: what its residuals r depend on, in pixels and radians and before any noise
/// level is applied.
///
/// Columns: the unknowns x that the pose depends on, and the deflections t of its joints (encoder errors and whatever
/// else moves the true angle away from the reading: one per joint and distinct encoder error), linearised at t = 0.
struct PosePart {
  std::vector<std::size_t> unknowns; // which ones, ascending
  std::vector<std::size_t> joints;   // per deflection: its joint; deflections of one joint stand together
  std::vector<std::size_t> errors;   // per deflection: which of its pose's encoder errors it has
  std::vector<double> errorScales;   // per deflection: its encoder error's size against the noise level
  std::vector<std::size_t> stances;  // per deflection: where the robot stood
  double squares = 0;                // sum of w r^2, w the loss's weight times `cornerShare`  [px^2]
  double loss = 0;                   // sum of rho, and of what else the pose's pictures cost
  double numbers = 0; // that count: two shares per corner with a weight above zero, three per sole on the floor
  double freedom = 0; // mean of squares / pixel^2 were there nothing but pixel noise
};

/// The same with its normal equations.
struct PoseSystem : PosePart {
  Eigen::MatrixXd unknownGram;        // sum of w J_x^T J_x      [px^2 / unknown^2]
  Eigen::MatrixXd jointErrorCross;    // sum of w J_x^T J_t
  Eigen::MatrixXd jointErrorGram;     // sum of w J_t^T J_t      [px^2 / rad^2]
  Eigen::VectorXd unknownGradient;    // sum of w J_x^T r
  Eigen::VectorXd jointErrorGradient; // sum of w J_t^T r
};

/// The same as rows: their products are those of all the pose's weighted corners, of which there are many more. A
/// picture has a handful of rows however many unknowns there are, so memory does not grow with their square.
struct PoseRows : PosePart {
  Eigen::MatrixXd byUnknowns;    // J_x  [px / unknown]
  Eigen::MatrixXd byDeflections; // J_t  [px / rad]
  Eigen::VectorXd residual;      // r    [px]
};

PoseSystem systemOf(const PoseRows& rows);

/// t = root * z with z of unit covariance: root root^T = encoder^2 diag(scales^2) + reapproach^2 1 + pose^2 1 1^T
/// within a joint, and + stance^2 1 1^T within a joint and stance.
using JointErrorRoot = Eigen::SparseMatrix<double>;
JointErrorRoot jointErrorRoot(const PosePart& pose, const Noise& noise);

/// The rows of one pose (`PoseRows`): for each of its pictures' groups as many as its corners tell numbers apart.
class RowEquations {
public:
  void clear(Eigen::Index columns);

  /// Adds sums over L, the derivative by the picture's motion (and extras): the rows are U C with U^T U = `gram`,
  /// C = motion * (the group's shares of the slopes' values), and their residuals U^-T `gradient`.
  void add(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
           const Eigen::MatrixXd& motion, const PreparedImage::Group& group, const double* slopeValues);

  /// Into `rows`, whose unknowns and joints are known: those columns, expressed at zero deflection.
  void takeRows(const Eigen::VectorXd& deflections, PoseRows& rows) const;

private:
  Eigen::Index columns_ = 0;
  std::vector<Eigen::MatrixXd> parts_; // per group: its columns, then the residual
};

/// A pose's deflections integrated out: Sigma = pixel^2 I + J_t S J_t^T by Woodbury on the deflections.
struct MarginalSystem {
  Eigen::LLT<Eigen::MatrixXd> inner; // I + root^T jointErrorGram root / pixel^2 = L L^T
  Eigen::MatrixXd half;              // L^-1 root^T J_t^T [J_x r] / pixel^2
  Eigen::MatrixXd hessian;           // J_x^T Sigma^-1 J_x
  Eigen::VectorXd unknownGradient;   // J_x^T Sigma^-1 r
  double cost = 0;                   // r^T Sigma^-1 r / 2
};
MarginalSystem marginalize(const PoseSystem& pose, const Noise& noise, const JointErrorRoot& root);
/// The same into `result`, whose memory is used again.
void marginalize(const PoseSystem& pose, const Noise& noise, const JointErrorRoot& root, MarginalSystem& result);

} // namespace naocal

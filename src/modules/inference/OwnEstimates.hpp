#pragma once

#include "inference/ScoreTest.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Precision of unknowns of which measurements count 1 / misfit and priors in full:
///   H / misfit + Lambda, from H + Lambda and the priors' sigmas.
/// The usual (H + Lambda) / misfit would widen the priors, too: what only a prior holds would be uncertain by
/// sqrt(misfit) times what is plausible.
Eigen::MatrixXd temperPrecision(const Eigen::MatrixXd& precision, const Eigen::VectorXd& sigmas, double misfit);

/// A problem linearised at a fit, all columns beside the own unknowns in units of what is plausible.
struct LinearWindow {
  const NullModel& alone;
  Eigen::MatrixXd explained;        // L^-1 H_og of all columns, L of `alone`
  Eigen::VectorXd own;              // L^-1 times the own unknowns' scores
  Eigen::VectorXd score;            // projected score of all columns at the linearisation point
  Eigen::VectorXd sizes, pull;      // coefficients there, and projected information times these
  const NullModel* plain = nullptr; // the own unknowns with all coefficients zero; null: as `alone`
};

/// Own unknowns x and coefficients c under one model: x = value + e + F u, c = coefficients + R u, with e of covariance
/// `OwnEstimates::covariance()` and u of covariance 1, independent.
struct OwnEstimate {
  Eigen::VectorXd value;
  Eigen::MatrixXd spread;            // F
  Eigen::VectorXd coefficients;      // of the model's columns
  Eigen::MatrixXd coefficientSpread; // R
};

/// Biases from columns that a model lacks and that stay unnoticed: of the own unknowns by `own` v, while the columns'
/// coefficients are `coefficients` v, |v| <= 1; the coefficients of the model's own columns, which take part of it, by
/// `taken` v.
struct UnnoticedBiases {
  Eigen::MatrixXd own, coefficients, taken;
};

/// Estimates of the own unknowns x under any model of a window, at a misfit phi that no model explains.
///
/// Quasi-likelihood (`temperPrecision`). With H the measurements' information, Lambda the priors', S the projected
/// information of the model's columns, c their coefficients and w the widths of their priors:
///   K = H / phi + Lambda,  B = K^-1 H_og / phi,  x = x_alone - B c,  C = K^-1 + B (S + diag(w)^-2)^-1 B^T.
///
/// Two rules keep linear steps where they hold. Both work in units of the priors' sigmas and leave directions D of x to
/// their priors: value of the linearisation point x_0, variance 1. All else is conditioned on x = x_0 along D, or
/// coefficients would keep what these directions compensate: with V = D^T C D, a = D^T (x_alone - x_0), B_D = D^T B,
///   S -> S + B_D^T V^-1 B_D,  score -> score + B_D^T V^-1 a,  C -> C - C D V^-1 D^T C + D D^T.
/// * Directions that the captures do not tell, with information below `threshold::untold` while all coefficients are
///   zero: adding unknowns adds no information about others. Derivatives at other coefficients can pretend some, as
///   where an eccentricity's phase moves with a joint's offset.
/// * A model that takes an unknown beyond `threshold::farthest` leaves its least determined directions to their priors,
///   as many as needed. Such a step is extrapolated.
class OwnEstimates {
public:
  OwnEstimates(const LinearWindow& linear, double misfit);

  /// Under a model with these columns. `information`: projected, of these columns, without priors; `widths`: prior
  /// sigma per column.
  OwnEstimate estimate(const std::vector<Eigen::Index>& columns, const Eigen::MatrixXd& information,
                       const Eigen::VectorXd& widths) const;
  /// Biases of a model from further columns that it lacks (`UndetectedEffect`). `columns`, `information`: of the model,
  /// then the further ones; `widths`: of the model; `noticed`: noncentrality at which they are noticed.
  UnnoticedBiases findUnnoticed(const std::vector<Eigen::Index>& columns, const Eigen::MatrixXd& information,
                                const Eigen::VectorXd& widths, double noticed) const;
  /// Under the model without further columns.
  const Eigen::MatrixXd& covariance() const { return covariance_; }

private:
  /// Information of columns at the misfit, from their projected information P: P / phi, what own unknowns that their
  /// priors hold firmer add, (1 - 1 / phi) B_1^T Lambda B, and what those left to their priors add.
  Eigen::MatrixXd informationOf(const std::vector<Eigen::Index>& columns, const Eigen::MatrixXd& projected) const;
  void leaveUntold(const NullModel& plain);
  /// Leaves directions, in sigmas, to their priors; without the priors' variance. `shares`: their variances.
  OwnEstimate leaveToPriors(const Eigen::MatrixXd& left, const Eigen::VectorXd& shares, OwnEstimate estimate) const;
  void keepPlausible(OwnEstimate& estimate) const;

  double misfit_;
  Eigen::VectorXd sigmas_, reference_;      // priors; the linearisation point
  Eigen::MatrixXd answers_, fullAnswers_;   // B, and its like where the measurements count in full
  Eigen::VectorXd alone_, score_;           // x_alone; projected scores, linearised at zero coefficients
  Eigen::MatrixXd held_;                    // V^-1/2 B_D along the directions that the captures do not tell
  Eigen::MatrixXd covariance_, directions_; // K^-1; its eigenvectors in sigmas, best determined first
  Eigen::VectorXd shares_;                  // their posterior variance as a share of the priors'
};

} // namespace naocal

#pragma once

#include "inference/ScoreProblem.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Likelihood of residuals under the model without candidates, at one noise level. Keeps a reference to `problem`.
class NullModel {
public:
  NullModel(const ScoreProblem& problem, const Noise& noise);

  /// Per set of residuals (column): -2 ln restricted likelihood and chi2, each up to a constant that is the same at all
  /// levels.
  struct Outcome {
    Eigen::RowVectorXd deviance, chi2;
    Eigen::MatrixXd own; // L^-1 times the scores of the own unknowns
  };
  /// Evaluates sets of residuals. `priorScore`: as `ScoreProblem::priorScore`, or zero for draws from the model.
  Outcome operator()(const PoseResiduals& residuals, const Eigen::VectorXd& priorScore) const;

  /// Whitening of a pose whose deflections have covariance R R^T:
  ///   J^T Sigma^-1 J = (J^T J - (B J)^T (B J)) / pixel^2,   B = L^-1 M^T, M = J_t R / pixel, L L^T = I + M^T M.
  /// Stores the factor B, since the product B^T B loses digits for sharp corners and loose joints.
  struct Whitener {
    Eigen::MatrixXd half;     // B, or a factor with the same product B^T B and at most as many rows as columns
    Eigen::MatrixXd unknowns; // B J_x / pixel of unknowns and candidates
  };
  const Whitener& whitener(std::size_t pose) const { return whiteners_[pose]; }
  /// Cholesky factor of the own unknowns' information, priors included: L L^T.
  const Eigen::LLT<Eigen::MatrixXd>& factor() const { return factor_; }
  const ScoreProblem& problem() const { return problem_; }
  const Noise& noise() const { return noise_; }

private:
  /// Information that the deflections take from the own unknowns.
  struct Taken {
    Eigen::MatrixXd information;
    double logDeterminant = 0;
  };
  void takeDeflections(std::size_t pose, Taken& taken);

  const ScoreProblem& problem_;
  Noise noise_;
  std::vector<Whitener> whiteners_;
  double logDeterminant_ = 0;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// Score (Lagrange multiplier) tests of all groups at one level of noise, everything already in the model projected out
/// (Rao 1948; Breusch and Pagan 1980):
///   s = G^T M Sigma^-1 r,  V = G^T M Sigma^-1 G,  fall of chi2 when the group is added: T = s^T V^-1 s.
class ScoreTest {
public:
  /// `alone` must outlive the tests.
  explicit ScoreTest(const NullModel& alone);

  /// Decrease of chi2 per group (row) and set of residuals (column). `own`: as in `NullModel::Outcome`.
  Eigen::MatrixXd chi2Decreases(const PoseResiduals& residuals, const Eigen::MatrixXd& own) const;

  /// Projected scores, negative gradient: one row per column of `ScoreProblem::groups`, one column per set of
  /// residuals.
  Eigen::MatrixXd projectedScores(const PoseResiduals& residuals, const Eigen::MatrixXd& own) const;
  /// Projected information between all columns (rows) and the first `count` columns of a group.
  Eigen::MatrixXd informationWith(std::size_t group, Eigen::Index count) const;
  /// Displacement of predicted corners by a group's coefficients, rms [px]; own unknowns refitted, joints as read.
  double movedPx(std::size_t group, const Eigen::VectorXd& coefficients) const;
  /// Projected information of a group's own columns.
  const Eigen::MatrixXd& informationOf(std::size_t group) const { return blocks_[group]; }
  /// L^-1 H_og of all columns g, with L of `NullModel::factor`. The own unknowns respond to one unit of column g by
  /// -L^-T times this.
  const Eigen::MatrixXd& explainedInformation() const { return explained_; }

  /// Projected information of the candidates' columns, without those of the map.
  const Eigen::MatrixXd& information() const { return information_; }
  /// Share of a group's information that the own unknowns do not absorb, in [0, 1].
  double keptFraction(std::size_t group) const { return kept_[group]; }
  /// Degrees of freedom of a group's chi2: directions that are not absorbed.
  Eigen::Index degreesOfFreedom(std::size_t group) const { return whitening_[group].rows(); }
  const Noise& noise() const { return alone_.noise(); }

private:
  struct Columns {                      // summed over poses, whitened, before projection
    Eigen::MatrixXd cross;              // own unknowns x candidates and map columns
    Eigen::MatrixXd candidates;         // candidates x candidates
    std::vector<Eigen::MatrixXd> cells; // per cell of the map

    Columns& operator+=(const Columns& other); // does not add `candidates`
  };
  static Columns makeEmptyColumns(const ScoreProblem& problem);
  void addCurves(std::size_t pose, Columns& columns);
  void project(const Columns& columns);
  Eigen::MatrixXd columnsOfGroup(std::size_t group, Eigen::Index count, std::size_t pose) const;

  const NullModel& alone_;
  std::vector<Eigen::MatrixXd> deflections_; // per pose: B J_t / pixel (`NullModel::Whitener`)
  Eigen::MatrixXd explained_;                // L^-1 cross: own unknowns x columns
  Eigen::MatrixXd information_;              // projected, of the candidates
  std::vector<Eigen::MatrixXd> blocks_;      // projected, per group
  std::vector<Eigen::MatrixXd> whitening_;   // per group: T = |whitening * s|^2
  std::vector<double> kept_;
};

/// The tests of what was measured, at one noise level. Keeps a reference to `problem`.
struct MeasuredTests {
  MeasuredTests(const ScoreProblem& problem, const Noise& noise);
  MeasuredTests(const MeasuredTests&) = delete; // `tests` refers to `alone`
  MeasuredTests& operator=(const MeasuredTests&) = delete;

  PoseResiduals residuals;
  NullModel alone;
  ScoreTest tests;
  NullModel::Outcome outcome; // of the model without groups
  Eigen::VectorXd scores;     // projected, one per column
};

} // namespace naocal

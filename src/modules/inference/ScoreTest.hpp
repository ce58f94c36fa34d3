#pragma once

#include "inference/ScoreProblem.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The model without any candidate at one level of noise: how likely residuals are under it.
class NullModel {
public:
  NullModel(const ScoreProblem& problem, const Noise& noise);

  /// Of each set of residuals (column): -2 ln of the model's restricted likelihood up to a constant, and chi2 up to a
  /// constant; both constants are the same at all levels.
  struct Outcome {
    Eigen::RowVectorXd deviance, chi2;
    Eigen::MatrixXd own; // L^-1 times the scores of the own unknowns
  };
  Outcome operator()(const PoseResiduals& residuals, const Eigen::VectorXd& priorScore) const;

  /// Of a pose whose deflections have the covariance R R^T:
  ///   J^T Sigma^-1 J = (J^T J - (B J)^T (B J)) / pixel^2,   B = L^-1 M^T, M = J_t R / pixel, L L^T = I + M^T M.
  /// A half, for the product B^T B loses the digits that sharp corners and loose joints need.
  struct Whitener {
    Eigen::MatrixXd half;     // B, or what has as few rows as J and the same product
    Eigen::MatrixXd unknowns; // B J_x / pixel, of the unknowns and candidates
  };
  const Whitener& whitener(std::size_t pose) const { return whiteners_[pose]; }
  /// Of the own unknowns' information, priors included: L L^T.
  const Eigen::LLT<Eigen::MatrixXd>& factor() const { return factor_; }
  const ScoreProblem& problem() const { return problem_; }
  const Noise& noise() const { return noise_; }

private:
  /// What deflections take of the own unknowns' information.
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

  /// How far each group (row) lowers chi2 of each set of residuals (column); `own`: the model's own part of their
  /// scores, as in `NullModel::Outcome`.
  Eigen::MatrixXd chi2Decreases(const PoseResiduals& residuals, const Eigen::MatrixXd& own) const;

  /// Scores of all columns, downhill, projected: one row per column, as `ScoreProblem::groups` counts them.
  Eigen::MatrixXd projectedScores(const PoseResiduals& residuals, const Eigen::MatrixXd& own) const;
  /// Projected information of all columns (rows) with the first `count` ones of a group's.
  Eigen::MatrixXd informationWith(std::size_t group, Eigen::Index count) const;
  /// How far a group's coefficients move predicted corners, the own unknowns refitted and joints as they were read:
  /// rms [px].
  double movedPx(std::size_t group, const Eigen::VectorXd& coefficients) const;
  /// Projected information of a group's own columns.
  const Eigen::MatrixXd& informationOf(std::size_t group) const { return blocks_[group]; }
  /// L^-1 H_og of all columns g, L of `NullModel::factor`: the own unknowns answer one unit of a column by -L^-T of
  /// it.
  const Eigen::MatrixXd& explainedInformation() const { return explained_; }

  /// Projected information of the candidates' columns (not of the map's).
  const Eigen::MatrixXd& information() const { return information_; }
  /// The part of a group's information that the own unknowns do not absorb.
  double keptFraction(std::size_t group) const { return kept_[group]; }
  /// Of a group's chi2: columns that are not absorbed.
  Eigen::Index degreesOfFreedom(std::size_t group) const { return whitening_[group].rows(); }
  const Noise& noise() const { return alone_.noise(); }

private:
  struct Columns {                      // of all poses, whitened, before projection
    Eigen::MatrixXd cross;              // own unknowns x candidates and map columns
    Eigen::MatrixXd candidates;         // candidates x candidates
    std::vector<Eigen::MatrixXd> cells; // per cell of the map

    Columns& operator+=(const Columns& other); // without the candidates
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

} // namespace naocal

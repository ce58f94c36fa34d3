#pragma once

#include "evidence/ModelAlone.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Score (Lagrange multiplier) tests of all groups at one level of noise, everything already in the model projected out
/// (Rao 1948; Breusch and Pagan 1980):
///   s = G^T M Sigma^-1 r,  V = G^T M Sigma^-1 G,  fall of chi2 when the group is added: T = s^T V^-1 s.
class ScoreTests {
public:
  /// `alone` must outlive the tests.
  explicit ScoreTests(const ModelAlone& alone);

  /// How far each group (row) lowers chi2 of each set of residuals (column); `own`: the model's own part of their
  /// scores, as in `ModelAlone::Outcome`.
  Eigen::MatrixXd falls(const PoseResiduals& residuals, const Eigen::MatrixXd& own) const;

  /// Scores of all columns, downhill, projected: one row per column, as `ScoreProblem::groups` counts them.
  Eigen::MatrixXd projectedScores(const PoseResiduals& residuals, const Eigen::MatrixXd& own) const;
  /// Projected information of all columns (rows) with the first `count` ones of a group's.
  Eigen::MatrixXd informationWith(std::size_t group, Eigen::Index count) const;
  /// How far a group's coefficients move predicted corners, the own unknowns refitted and joints as they were read:
  /// rms [px].
  double movedPx(std::size_t group, const Eigen::VectorXd& coefficients) const;
  /// Projected information of a group's own columns.
  const Eigen::MatrixXd& informationOf(std::size_t group) const { return blocks_[group]; }
  /// L^-1 H_og of all columns g, L of `ModelAlone::factor`: the own unknowns answer one unit of a column by -L^-T of
  /// it.
  const Eigen::MatrixXd& explained() const { return explained_; }

  /// Projected information of the candidates' columns (not of the map's).
  const Eigen::MatrixXd& information() const { return information_; }
  /// The part of a group's information that the own unknowns do not absorb.
  double keptFraction(std::size_t group) const { return kept_[group]; }
  /// Of a group's chi2: columns that are not absorbed.
  Eigen::Index freedom(std::size_t group) const { return whitening_[group].rows(); }
  const Noise& noise() const { return alone_.noise(); }

private:
  struct Columns {                      // of all poses, whitened, before projection
    Eigen::MatrixXd cross;              // own unknowns x candidates and map columns
    Eigen::MatrixXd candidates;         // candidates x candidates
    std::vector<Eigen::MatrixXd> cells; // per cell of the map

    Columns& operator+=(const Columns& other); // without the candidates
  };
  static Columns noColumns(const ScoreProblem& problem);
  void addCurves(std::size_t pose, Columns& columns);
  void project(const Columns& columns);
  Eigen::MatrixXd byColumns(std::size_t group, Eigen::Index count, std::size_t pose) const;

  const ModelAlone& alone_;
  std::vector<Eigen::MatrixXd> deflections_; // per pose: B J_t / pixel (`ModelAlone::Whitener`)
  Eigen::MatrixXd explained_;                // L^-1 cross: own unknowns x columns
  Eigen::MatrixXd information_;              // projected, of the candidates
  std::vector<Eigen::MatrixXd> blocks_;      // projected, per group
  std::vector<Eigen::MatrixXd> whitening_;   // per group: T = |whitening * s|^2
  std::vector<double> kept_;
};

} // namespace naocal

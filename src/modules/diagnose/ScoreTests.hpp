#pragma once

#include "diagnose/DriverColumns.hpp"
#include "diagnose/PoseScores.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Columns that stand or fall together: an effect's unknowns, or a curve of the map's.
struct ColumnGroup {
  Eigen::Index first = 0, count = 0; // among the candidates' columns
  Eigen::Index part = 0;             // of a smooth curve: columns per degree; the first few may suffice
  std::size_t choices = 1;           // groups of which at most one is true: a priori it is this one as often as another
};

/// What score tests are about. `linear` has the model's own unknowns first, then the candidates' columns: those of
/// candidate effects and of the mounts' curves; behind them come the joints' curves, the columns of `map`.
struct ScoreProblem {
  const Residuals::Linear* linear;
  const DriverColumns* map;
  Eigen::VectorXd unknowns;        // the own unknowns where `linear` was taken
  Eigen::VectorXd sigmas;          // their priors
  std::vector<ColumnGroup> groups; // candidate effects, the mounts' curves, then the map's cells
  std::size_t named = 0;           // how many of the groups are candidate effects
  Eigen::Index candidates = 0;     // columns that `linear` has beyond the own unknowns
  Eigen::VectorXd plausible;       // per column of a group: how large its coefficient plausibly is

  Eigen::Index own() const { return sigmas.size(); }
};

/// -2 ln of the half-Cauchy prior of pose noise [rad], up to a constant: few poses hardly tell an effect from scatter
/// beyond what robots have, some 0.02 degrees (Gelman, Bayesian Analysis 1 (2006) 515).
double scatterPenalty(double level);

/// Score (Lagrange multiplier) tests of all groups at one level of noise, everything already in the model projected out
/// (Rao 1948; Breusch and Pagan 1980):
///   s = G^T M Sigma^-1 r,  V = G^T M Sigma^-1 G,  fall of chi2 when the group is added: T = s^T V^-1 s.
class ScoreTests {
public:
  ScoreTests(const ScoreProblem& problem, const Noise& noise);

  /// Of each set of scores (column): -2 ln of the model's own restricted likelihood times the prior of the pose noise,
  /// up to a constant; chi2 up to a constant that is the same at all levels; how far each group (row) lowers it.
  struct Outcome {
    Eigen::RowVectorXd deviance, chi2;
    Eigen::MatrixXd falls;
  };
  Outcome operator()(const PoseScores& scores, const Eigen::VectorXd& priorScore) const;
  /// Without the falls: cheap.
  Outcome modelAlone(const PoseScores& scores, const Eigen::VectorXd& priorScore) const;

  /// A group's projected score and information, in the candidates' own units.
  struct GroupScore {
    Eigen::VectorXd score; // of a better fit: the estimate is information^-1 * score
    Eigen::MatrixXd information;
  };
  std::vector<GroupScore> groups(const PoseScores& scores, const Eigen::VectorXd& priorScore) const;

  /// Projected information of the candidates' columns (not of the map's).
  const Eigen::MatrixXd& information() const { return information_; }
  /// The part of a group's information that the own unknowns do not absorb.
  double keptFraction(std::size_t group) const { return kept_[group]; }
  /// Of a group's chi2: columns that are not absorbed.
  Eigen::Index freedom(std::size_t group) const { return whitening_[group].rows(); }
  const Noise& noise() const { return noise_; }

private:
  struct Whitener {           // of a pose, P = S - S (S + (J_t^T J_t)^-1)^-1 S:  J^T Sigma^-1 = J^T - J^T J_t P J_t^T
    Eigen::MatrixXd inner;    // P
    Eigen::MatrixXd unknowns; // J_x^T J_t P
    Eigen::MatrixXd deflections; // J_t^T J_t P
  };
  void addPose(std::size_t pose);
  void project();
  void ownScores(const PoseScores& scores, const Eigen::VectorXd& priorScore, Outcome& outcome,
                 Eigen::MatrixXd& own) const;
  Eigen::MatrixXd projectedScores(const PoseScores& scores, const Eigen::MatrixXd& own) const;

  const ScoreProblem& problem_;
  Noise noise_;
  std::vector<Whitener> whiteners_;
  double logDeterminant_ = 0;
  Eigen::MatrixXd hessian_;                // of own unknowns and candidates
  Eigen::MatrixXd mapCross_;               // own unknowns x map columns
  std::vector<Eigen::MatrixXd> cells_;     // per cell of the map: its information before projection
  Eigen::LLT<Eigen::MatrixXd> own_;        // of the own unknowns' information, priors included: L L^T
  Eigen::MatrixXd explained_;              // L^-1 cross: own unknowns x columns
  Eigen::MatrixXd information_;            // projected, of the candidates
  std::vector<Eigen::MatrixXd> blocks_;    // projected, per group
  std::vector<Eigen::MatrixXd> whitening_; // per group: T = |whitening * s|^2
  std::vector<double> kept_;
};

} // namespace naocal

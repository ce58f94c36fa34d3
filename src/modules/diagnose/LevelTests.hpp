#pragma once

#include "diagnose/ScoreTests.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace naocal {

/// Levels of pose noise to try: none, then in steps from what no one can see to more than any robot has, one of them
/// the likeliest under the model alone [rad]. (The noise of a bootstrap is drawn there: a level that is off by half a
/// step would make whatever is measured look striking or dull.)
std::vector<double> poseLevels(const ScoreProblem& problem, const Noise& noise, const PoseScores& measured);

/// Scores under the model alone, the level of pose noise estimated for each set of them (column).
struct NullFit {
  std::vector<std::size_t> level;            // the likeliest
  Eigen::RowVectorXd deviance;               // -2 ln likelihood there
  std::vector<ModelAlone::Outcome> outcomes; // at each level
};

/// Score tests at several levels of pose noise, which are looked at side by side on all cores. Those of a level that no
/// scores need are never made.
class LevelTests {
public:
  LevelTests(const LevelTests&) = delete; // its tests point into it
  LevelTests& operator=(const LevelTests&) = delete;
  /// `levels`: of pose noise, ascending [rad]; all other noise as in `noise`.
  LevelTests(const ScoreProblem& problem, const Noise& noise, const std::vector<double>& levels);

  NullFit nullOf(const PoseScores& scores, const Eigen::VectorXd& priorScore) const;

  /// Likelihood ratio of every group (row) for every set of scores (column), pose noise estimated with and without it.
  /// A group can only lower the pose noise, so that levels above the null's are not tried.
  Eigen::MatrixXd ratios(const PoseScores& scores, const NullFit& null);

  const ScoreTests& operator[](std::size_t level);
  /// The place of the first level that is not below this one [rad].
  std::size_t placeOf(double level) const;

private:
  std::vector<std::optional<ModelAlone>> alone_; // all there
  std::vector<std::optional<ScoreTests>> tests_;
};

} // namespace naocal

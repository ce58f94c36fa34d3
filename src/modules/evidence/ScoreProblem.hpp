#pragma once

#include "evidence/DriverColumns.hpp"
#include "residuals/PoseSystem.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// Columns that stand or fall together: an effect's unknowns, or a curve of the map's.
struct ColumnGroup {
  Eigen::Index first = 0, count = 0; // among the candidates' columns
  Eigen::Index part = 0;             // of a smooth curve: columns per degree; the first few may suffice
  std::size_t choices = 1;           // groups of which at most one is true: a priori it is this one as often as another
};

/// What score tests are about. `poses` have the model's own unknowns first, then the candidates' columns: those of
/// candidate effects and of the mounts' curves; behind them come the joints' curves, the columns of `map`.
struct ScoreProblem {
  ScoreProblem() = default;
  /// Without any groups.
  ScoreProblem(const std::vector<PoseRows>& poses, const DriverColumns& map, Eigen::VectorXd unknowns,
               Eigen::VectorXd sigmas, Eigen::Index candidates);

  const std::vector<PoseRows>* poses = nullptr;
  const DriverColumns* map = nullptr;
  Eigen::MatrixXd gram;            // J_x^T J_x of all poses, own unknowns and candidates [px^2 / unknown^2]
  Eigen::VectorXd unknowns;        // the own unknowns where `poses` were linearised
  Eigen::VectorXd sigmas;          // their priors
  std::vector<ColumnGroup> groups; // candidate effects, the mounts' curves, then the map's cells
  std::size_t named = 0;           // how many of the groups are candidate effects
  Eigen::Index candidates = 0;     // columns that `poses` have beyond the own unknowns
  Eigen::VectorXd plausible;       // per column of a group: how large its coefficient plausibly is

  Eigen::Index own() const { return sigmas.size(); }
  /// How many of a pose's unknowns are the model's own: the first of them; and these.
  Eigen::Index ownOf(const PosePart& pose) const;
  std::vector<std::size_t> ownUnknownsOf(const PosePart& pose) const;
  /// -2 ln of the own unknowns' prior: half of its gradient where `poses` were linearised.
  Eigen::VectorXd priorScore() const { return unknowns.cwiseQuotient(sigmas.cwiseAbs2()); }
};

} // namespace naocal

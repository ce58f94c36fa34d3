#pragma once

#include "estimation/Marginalization.hpp"
#include "inference/DriverBasis.hpp"
#include "measurements/Noise.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace naocal {

/// The sum of rows^T rows over many poses, each with columns of its own: taken together by the hundred, since a tall
/// matrix is multiplied faster than many flat ones.
class GramSum {
public:
  explicit GramSum(Eigen::Index columns);

  /// `columns`: which one each of the rows' columns is.
  void add(const std::vector<std::size_t>& columns, const Eigen::MatrixXd& rows);
  /// Symmetric; what was added so far.
  Eigen::MatrixXd sum();

private:
  void multiply();

  Eigen::MatrixXd sum_;     // its lower half
  Eigen::MatrixXd waiting_; // rows
  Eigen::Index count_ = 0;  // of rows that wait
};

/// Per pose its residuals [px], one row per row of `PoseRows`, one column per draw.
using PoseResiduals = std::vector<Eigen::MatrixXd>;

/// Those of the measurements themselves, where `poses` was linearised.
PoseResiduals measuredResiduals(const std::vector<PoseRows>& poses);

/// `draws` sets of residuals that are nothing but noise: r ~ N(0, pixel^2 I + J_t S J_t^T). The same seed gives the
/// same draws.
PoseResiduals drawResiduals(const std::vector<PoseRows>& poses, const Noise& noise, Eigen::Index draws,
                            std::uint64_t seed);

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

  Eigen::Index ownCount() const { return sigmas.size(); }
  /// How many of a pose's unknowns are the model's own: the first of them; and these.
  Eigen::Index ownCountIn(const PosePart& pose) const;
  std::vector<std::size_t> ownUnknownsIn(const PosePart& pose) const;
  /// -2 ln of the own unknowns' prior: half of its gradient where `poses` were linearised.
  Eigen::VectorXd priorScore() const { return unknowns.cwiseQuotient(sigmas.cwiseAbs2()); }
};

} // namespace naocal

#pragma once

#include "estimation/Marginalization.hpp"
#include "inference/DriverBasis.hpp"
#include "measurements/Noise.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace naocal {

/// Accumulates the sum of rows^T rows over many poses with different columns. Batches 128 rows per product: one tall
/// product is faster than many flat ones.
class GramSum {
public:
  explicit GramSum(Eigen::Index columns);

  /// `columns`: index of each column of `rows` within the sum.
  void add(const std::vector<std::size_t>& columns, const Eigen::MatrixXd& rows);
  /// The symmetric sum of all rows added so far.
  Eigen::MatrixXd sum();

private:
  void multiply();

  Eigen::MatrixXd sum_;     // lower half only
  Eigen::MatrixXd waiting_; // rows not yet multiplied
  Eigen::Index count_ = 0;  // number of waiting rows
};

/// Residuals per pose [px]: one row per row of `PoseRows`, one column per draw.
using PoseResiduals = std::vector<Eigen::MatrixXd>;

/// Residuals of the measurements at the linearisation point of `poses`.
PoseResiduals measuredResiduals(const std::vector<PoseRows>& poses);

/// Draws `draws` sets of pure noise, r ~ N(0, pixel^2 I + J_t S J_t^T), reproducible by `seed`.
PoseResiduals drawResiduals(const std::vector<PoseRows>& poses, const Noise& noise, Eigen::Index draws,
                            std::uint64_t seed);

/// Columns that enter a model together: the unknowns of an effect, or a curve of the driver map.
struct ColumnGroup {
  Eigen::Index first = 0, count = 0; // range among the candidates' columns
  Eigen::Index part = 0;   // columns per degree of a smooth curve (its first degrees may suffice); 0: no degrees
  std::size_t choices = 1; // size of its set of groups, at most one of which is true (equal prior odds)
};

/// The linearised problem of the score tests. Columns of `poses`: first the model's own unknowns, then candidate
/// effects, then the mounts' curves. The joints' curves follow as columns of `map`.
struct ScoreProblem {
  ScoreProblem() = default;
  /// Creates a problem without groups.
  ScoreProblem(const std::vector<PoseRows>& poses, const DriverColumns& map, Eigen::VectorXd unknowns,
               Eigen::VectorXd sigmas, Eigen::Index candidates);

  const std::vector<PoseRows>* poses = nullptr;
  const DriverColumns* map = nullptr;
  Eigen::MatrixXd gram;            // J_x^T J_x of all poses, own unknowns and candidates [px^2 / unknown^2]
  Eigen::VectorXd unknowns;        // own unknowns at the linearisation point of `poses`
  Eigen::VectorXd sigmas;          // prior standard deviations of the own unknowns
  std::vector<ColumnGroup> groups; // candidate effects, the mounts' curves, then the map's cells
  std::size_t named = 0;           // number of groups that are candidate effects
  Eigen::Index candidates = 0;     // number of columns of `poses` beyond the own unknowns
  Eigen::VectorXd plausible;       // prior scale of each candidate column's coefficient
  Eigen::VectorXd sizes;           // coefficients at the linearisation point; empty: zero
  const std::vector<PoseRows>* plain = nullptr; // own unknowns' rows with all coefficients zero; null: those of `poses`

  Eigen::Index ownCount() const { return sigmas.size(); }
  /// Own unknowns among a pose's unknowns (they come first): their number, and their indices.
  Eigen::Index ownCountIn(const PosePart& pose) const;
  std::vector<std::size_t> ownUnknownsIn(const PosePart& pose) const;
  /// Half the gradient of -2 ln prior of the own unknowns, at the linearisation point of `poses`.
  Eigen::VectorXd priorScore() const { return unknowns.cwiseQuotient(sigmas.cwiseAbs2()); }
};

/// The problem without curves. Keeps a reference to its poses.
class EffectsOnly {
public:
  explicit EffectsOnly(const ScoreProblem& wide);
  /// Only with the marked effects, one mark per named group: no size of another one is plausible.
  EffectsOnly(const ScoreProblem& wide, const std::vector<bool>& marked);
  EffectsOnly(const EffectsOnly&) = delete; // problem_ points into this object
  EffectsOnly& operator=(const EffectsOnly&) = delete;

  const ScoreProblem& problem() const { return problem_; }

private:
  DriverColumns none_;
  ScoreProblem problem_;
};

} // namespace naocal

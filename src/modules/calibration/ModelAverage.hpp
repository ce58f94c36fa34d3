#pragma once

#include "calibration/LevelSpread.hpp"
#include "calibration/ModelUncertainty.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Posterior of linear functions of a fitted model's unknowns, averaged over everything that may be missing: a mixture
///   sum w_m t_nu(value_m, s_m)
/// over the window's models m. Its tails are Student's t, not a normal distribution times a factor: the noise levels'
/// uncertainty and the misfit's degrees of freedom make the variance uncertain, which widens a 99.95 % bound by far
/// more than a 95 % interval. With relative spreads a (of the levels' variance) and b = 2 / (f - 4) (of a misfit above
/// 1 with f degrees of freedom): nu = 4 + 2 / ((1 + a) (1 + b) - 1).
class ModelAverage {
public:
  ModelAverage(const MissingEffectAnalysis& explained, const Model& model);
  ModelAverage(MissingEffectAnalysis&&, const Model&) = delete; // keeps a reference

  /// Of one unknown of the model.
  Averaged of(Eigen::Index unknown) const;
  /// Of a linear function of the own unknowns and of all columns' coefficients (`ModelWindow::along`). `direction`: the
  /// like by the model's unknowns, for the noise levels' share.
  Averaged along(const Eigen::VectorXd& direction, const Eigen::VectorXd& own, const Eigen::VectorXd& columns) const;
  /// Unknowns of the model that have an average.
  std::vector<Eigen::Index> unknowns() const;
  /// The largest shift of a point that one effect alone can cause unnoticed, of the "task". `own`, `columns`: its
  /// slopes as rows. Absent without candidate effects.
  std::optional<Undetectable> worstBias(const Eigen::MatrixXd& own, const Eigen::MatrixXd& columns) const;
  /// The same of one unknown: effect and size.
  std::optional<std::pair<std::string, double>> worstBiasOf(Eigen::Index unknown) const;
  /// What the models are made of, linearised.
  const WideModel& wide() const { return *explained_.wide; }
  /// The models by their effects, whatever the effects' sizes: likeliest first, with weight.
  const std::vector<Explanation>& explanations() const { return explanations_; }

private:
  /// Index of one of the model's unknowns among the own unknowns.
  std::optional<Eigen::Index> ownIndex(Eigen::Index unknown) const;
  StudentMixture mixtureOf(const std::vector<StudentMixture::Part>& parts, const UncertainVariance& variance) const;
  std::optional<Shoulder> findShoulder(const std::vector<StudentMixture::Part>& parts,
                                       const UncertainVariance& variance) const;
  std::vector<StudentMixture::Part> partsOf(const std::vector<StudentMixture::Part>& parts,
                                            std::initializer_list<std::size_t> explanations) const;

  const MissingEffectAnalysis& explained_;
  const ModelWindow& window_;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> shared_; // (index in the model, index among the own unknowns)
  LevelSpread levels_;
  std::vector<Explanation> explanations_;
  std::vector<std::vector<std::size_t>> models_; // of each explanation, as indices into the window
};

} // namespace naocal

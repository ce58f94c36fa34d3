#pragma once

#include "estimation/Model.hpp"
#include "inference/DriverBasis.hpp"
#include "inference/ScoreProblem.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// Linearisation point of a model: a fit.
struct FittedPoint {
  Residuals::State state; // the model's unknowns, then those of the first candidates where nonzero
  Noise noise;            // noise levels of the fit
  Loss loss;
};

/// A model with every candidate effect and every curve of a joint or camera mount over the recorded drivers: the widest
/// explanation that the captures allow, linearised at a fit.
class WideModel {
public:
  WideModel(const WideModel&) = delete; // problem_ points into this object
  WideModel& operator=(const WideModel&) = delete;
  /// `curves`: whether to include curves. Throws InputError if the fit puts an
  /// observed corner behind the camera.
  WideModel(const Measurements& measurements, const Model& model, std::vector<Term> candidates,
            const FittedPoint& point, bool curves);

  const std::vector<Term>& candidates() const { return candidates_; }
  /// The model with the candidates and the mounts' curves, and its unknowns at the linearisation point.
  const Model& extended() const { return extended_; }
  const Eigen::VectorXd& unknowns() const { return unknowns_; }
  const std::vector<PoseRows>& poses() const { return poses_; }
  const std::vector<MountCurve>& mounts() const { return mounts_; }
  const DriverColumns& map() const { return map_; }
  const ScoreProblem& problem() const { return problem_; }

private:
  /// Fills `ScoreProblem::plain`, unless without the effects a corner that was seen would lie behind the camera.
  void linearizePlainly(const Measurements& measurements, const Model& model, const FittedPoint& point);

  std::vector<Term> candidates_;
  Model extended_;
  Eigen::VectorXd unknowns_;
  std::vector<MountCurve> mounts_;
  std::vector<PoseRows> poses_, plain_;
  DriverColumns map_;
  ScoreProblem problem_;
};

} // namespace naocal

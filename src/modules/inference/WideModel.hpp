#pragma once

#include "estimation/Model.hpp"
#include "inference/DriverBasis.hpp"
#include "inference/ScoreProblem.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// Where a model is linearised: at a fit.
struct FittedPoint {
  Residuals::State state; // the model's unknowns, then those of the first few candidates where they are not zero
  Noise noise;            // the levels it was fitted with
  Loss loss;
};

/// A model with every candidate effect in it, and with every curve of a joint or a camera mount over what was recorded:
/// the widest explanation that these captures allow, linearised at a fit.
class WideModel {
public:
  WideModel(const WideModel&) = delete; // its problem points into it
  WideModel& operator=(const WideModel&) = delete;
  /// `curves`: with the curves. Throws InputError where the fit is impossible.
  WideModel(const Measurements& measurements, const Model& model, std::vector<Term> candidates,
            const FittedPoint& point, bool curves);

  const std::vector<Term>& candidates() const { return candidates_; }
  const std::vector<PoseRows>& poses() const { return poses_; }
  const std::vector<MountCurve>& mounts() const { return mounts_; }
  const DriverColumns& map() const { return map_; }
  const ScoreProblem& problem() const { return problem_; }
  const std::string& jointName(std::size_t joint) const { return measurements_.robot.joints[joint].name; }
  /// The sizes of all columns where it was linearised: zero but for the candidates' that were given.
  const Eigen::VectorXd& sizes() const { return sizes_; }

private:
  const Measurements& measurements_;
  std::vector<Term> candidates_;
  std::vector<MountCurve> mounts_;
  std::vector<PoseRows> poses_;
  DriverColumns map_;
  ScoreProblem problem_;
  Eigen::VectorXd sizes_;
};

} // namespace naocal

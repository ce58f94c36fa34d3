#pragma once

#include "poses/candidates/PoseSampler.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "poses/criteria/PlannedInformation.hpp"

namespace naocal {

/// Evaluates how well poses distinguish the two PlanOptions::effects, by Discrimination: simulated captures, linearised
/// at the drawing. Offsets, camera mounts and boards are unknown; the effects have their plausible sizes and equal
/// odds.
class EffectPairCriterion {
public:
  EffectPairCriterion(const Robot& robot, const std::vector<Board>& boards,
                      const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options);

  /// Selects greedily and by exchange the poses that maximise the misfits of the wrong effect (mean of the logarithms),
  /// given `kept`. If an effect depends on the approach, each pose gets its best approach. Throws InputError unless
  /// there are two effects that such captures can test.
  std::vector<ValidPose> selectPoses(const std::vector<ValidPose>& kept, const std::vector<ValidPose>& candidates,
                                     std::size_t count) const;

  /// Misfit (chi2) of the wrong effect after these poses; the smaller of both.
  double misfit(const std::vector<ValidPose>& kept, const std::vector<ValidPose>& poses) const;

private:
  /// Information about the model's own unknowns, followed by those of the effects.
  struct Told {
    Eigen::Index own;
    ModelAmbiguity question;
    bool byApproach; // an effect depends on the approach
    Eigen::MatrixXd prior;
    std::vector<Eigen::MatrixXd> poses;
  };
  Told tellApart(const std::vector<ValidPose>& poses) const;
  CaptureSet captures(const std::vector<ValidPose>& poses) const;

  const Robot& robot_;
  const std::vector<Board>& boards_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  PlanningScene scene_;
};

} // namespace naocal

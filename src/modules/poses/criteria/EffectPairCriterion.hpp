#pragma once

#include "poses/candidates/PoseSampler.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "poses/criteria/PlannedInformation.hpp"

namespace naocal {

/// How well poses tell which of two effects a robot has (PlanOptions::effects), by Discrimination: captures in these
/// poses by the measurement model, linearised at the drawing; offsets, camera mounts and boards are unknown along with
/// the effects, which are as large as they plausibly may be, and of even odds.
class EffectPairCriterion {
public:
  EffectPairCriterion(const Robot& robot, const std::vector<Board>& boards,
                      const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options);

  /// Greedily and by exchange, the poses after which the misfits of the wrong effect are largest (the mean of their
  /// logarithms), beside those that are `kept`. Where an effect looks at it each pose gets the approach that it is to
  /// be taken with. Throws InputError where the effects are not two, or have no place in such captures.
  std::vector<ValidPose> selectPoses(const std::vector<ValidPose>& kept, const std::vector<ValidPose>& candidates,
                                     std::size_t count) const;

  /// By how much chi2 the wrong one fits worse after these poses; the smaller of both.
  double misfit(const std::vector<ValidPose>& kept, const std::vector<ValidPose>& poses) const;

private:
  /// What captures tell about the model's own unknowns and the effects' behind them.
  struct Told {
    Eigen::Index own;
    ModelAmbiguity question;
    bool byApproach; // an effect looks at it
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

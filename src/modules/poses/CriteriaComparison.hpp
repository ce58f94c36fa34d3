#pragma once

#include "poses/PlanScore.hpp"

namespace naocal {

/// What a criterion's selection of poses is worth.
struct CriterionResult {
  Criterion criterion = Criterion::worst;
  std::size_t poses = 0;
  double worst = 0,
         mean = 0;       // sigma of a joint's offset, cameras and boards unknown; mean: root of the mean square [rad]
  double worstKnown = 0; // the same with cameras and boards known [rad]
  Interaction interaction;
  std::optional<double> misfit; // by which they tell PlanOptions::effects apart (chi2)
};

/// Every criterion's (`discriminate` where there are effects to tell apart) selection of 3, 5 and 8 poses among the
/// same candidates, with the boards where they are; nothing is refined. Fewer where there are not as many candidates,
/// or the thesis's chain ends.
std::vector<CriterionResult> compareCriteria(const Robot& robot, const std::vector<Board>& boards,
                                             const std::map<std::string, CameraIntrinsics>& cameras,
                                             const PlanOptions& options, const std::vector<SievedPose>& candidates);

} // namespace naocal

#include "diagnosis/evidence/LackOfFit.hpp"

#include "inference/NoiseLevels.hpp"
#include "inference/PoseMisfit.hpp"

#include <algorithm>

namespace naocal {

LackOfFit testLackOfFit(const CandidateTests& inquiry) {
  const PoseMisfit misfit = testPoseMisfit(inquiry.problem(), inquiry.noise());
  double freedom = 0;
  for (const PoseRows& pose : inquiry.poses()) {
    freedom += pose.freedom;
  }
  LackOfFit result;
  result.statistic = misfit.chi2 / misfit.freedom;
  result.dof[0] = misfit.freedom;
  result.dof[1] = std::max(0.0, freedom - misfit.directions);
  result.pValue = inquiry.evidence().pValue;
  result.noiseFloorPx = noiseFloorPx(inquiry.poses(), inquiry.noise());
  return result;
}

} // namespace naocal

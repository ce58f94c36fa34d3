#include "diagnosis/evidence/LackOfFit.hpp"

#include "inference/NoiseLevels.hpp"
#include "inference/PoseMisfit.hpp"

#include <algorithm>

namespace naocal {

LackOfFit testLackOfFit(const CandidateTests& candidateTests) {
  const PoseMisfit misfit = testPoseMisfit(candidateTests.problem(), candidateTests.noise());
  double freedom = 0;
  for (const PoseRows& pose : candidateTests.poses()) {
    freedom += pose.freedom;
  }
  LackOfFit result;
  result.statistic = misfit.chi2 / misfit.freedom;
  result.dof[0] = misfit.freedom;
  result.dof[1] = std::max(0.0, freedom - misfit.directions);
  result.pValue = candidateTests.evidence().pValue;
  result.noiseFloorPx = noiseFloorPx(candidateTests.poses(), candidateTests.noise());
  return result;
}

} // namespace naocal

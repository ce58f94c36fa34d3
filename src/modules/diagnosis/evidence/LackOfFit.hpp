#pragma once

#include "calibration/CandidateTests.hpp"

namespace naocal {

/// Size of the misfit between poses, beyond noise (`PoseMisfit`), and its significance.
///   statistic = chi2 / dof[0]
/// The statistic has no p-value of its own, since its noise levels were estimated from the same poses. `pValue` is that
/// of the most striking candidate (`Evidence`), which remains valid.
struct LackOfFit {
  double statistic = 0;
  double dof[2] = {0, 0}; // of the statistic; of the residuals within poses
  double pValue = 1;
  double noiseFloorPx = 0; // expected rms distance of corners under noise alone [px]
};
/// At the fit and the noise levels of the candidate tests.
LackOfFit testLackOfFit(const CandidateTests& candidateTests);

} // namespace naocal

#pragma once

#include "diagnosis/evidence/CandidateTests.hpp"

namespace naocal {

/// How far the model fails from pose to pose, by more than its noise (`PoseMisfit`), and whether that is chance.
///   statistic = chi2 / dof[0]
/// It is a size, without a p-value of its own: its levels of noise were estimated from the same poses. The p-value is
/// that of the most striking sign that something is missing (`Evidence`), which does not lose its meaning by that.
struct LackOfFit {
  double statistic = 0;
  double dof[2] = {0, 0}; // of the statistic; of what is left within poses
  double pValue = 1;
  double noiseFloorPx = 0; // rms distance of corners that noise alone makes
};
LackOfFit testLackOfFit(const CandidateTests& inquiry);

} // namespace naocal

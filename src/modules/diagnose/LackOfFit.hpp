#pragma once

#include "diagnose/Inquiry.hpp"

namespace naocal {

/// Does the model fail from pose to pose by more than readings of one pose differ?
///   F = ((chi2(no pose noise) - chi2(poses free)) / dof[0]) / (chi2(poses free) / dof[1])
/// where "free" lets every joint deflect anew in every pose. Where pictures hold too little to tell the noise (one mark
/// each), the noise is taken as known: chi2 instead of F, and dof[1] is 0. Beside it how large the noise alone would be
/// in pixels.
struct LackOfFit {
  double statistic = 0;
  double dof[2] = {0, 0};
  double pValue = 1;
  double noiseFloorPx =
      0; // rms distance of corners that noise alone makes; with pose noise unless something is missing
};
LackOfFit lackOfFit(const Inquiry& inquiry);

} // namespace naocal

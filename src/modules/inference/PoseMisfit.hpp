#pragma once

#include "inference/ScoreProblem.hpp"

namespace naocal {

/// How far poses miss the model beyond what readings of one pose differ:
///   chi2 = chi2(the levels of noise) - chi2(every joint deflects anew in every pose),
///   freedom = E(chi2) where the model and the levels are right
///           = sum over poses tr(J^T V^-1 J D) - tr((A^T V^-1 A + Lambda)^-1 A^T V^-1 J D J^T V^-1 A),
/// V the covariance with joints set free, D what setting them free adds to the covariance of their deflections, J and A
/// the slopes by deflections and by own unknowns.
struct PoseMisfit {
  double chi2 = 0, freedom = 0;
  double directions = 0; // of the poses' deflections that the pictures tell: the first sum
  double within = 0;     // chi2 with every joint free
};
PoseMisfit testPoseMisfit(const ScoreProblem& problem, const Noise& noise);

} // namespace naocal

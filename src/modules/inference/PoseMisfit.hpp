#pragma once

#include "inference/ScoreProblem.hpp"

namespace naocal {

/// Misfit between poses, beyond the scatter within a pose:
///   chi2 = chi2(given noise levels) - chi2(every joint deflects freely in every pose),
///   freedom = E(chi2) under a correct model and correct levels
///           = sum over poses tr(J^T V^-1 J D) - tr((A^T V^-1 A + Lambda)^-1 A^T V^-1 J D J^T V^-1 A),
/// V the covariance with free joints, D the increase of the deflections' covariance from freeing them, J and A the
/// Jacobians with respect to deflections and to own unknowns.
struct PoseMisfit {
  double chi2 = 0, freedom = 0;
  double directions = 0; // identifiable directions of the poses' deflections: the first sum of `freedom`
  double within = 0;     // chi2 with all joints free
};
/// Evaluates the misfit at the given noise levels.
PoseMisfit testPoseMisfit(const ScoreProblem& problem, const Noise& noise);

} // namespace naocal

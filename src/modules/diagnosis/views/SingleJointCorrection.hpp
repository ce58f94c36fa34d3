#pragma once

#include "calibration/CandidateTests.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// Deflection of a single joint that best explains the residuals of some readings of a pose, with encoder noise in all
/// joints and zero pose noise:
///
///   a = -(J_t^T Sigma^-1 r) / (J_t^T Sigma^-1 J_t),  sigma = (J_t^T Sigma^-1 J_t)^-1/2
struct JointCorrection {
  std::vector<std::size_t> pictures; // of this encoder reading
  double deflection = 0, sigma = 0;  // [rad]
  double gradient = 0, gram = 0;     // sums over its corners: w J_t^T r [px^2/rad], w J_t^T J_t [px^2/rad^2]
};

/// Corrections of one joint (motor), pose by pose.
struct SingleJointCorrection {
  std::size_t motor = 0;
  std::vector<JointCorrection> points;
};

/// For each joint in use, at the linearisation point of the residuals.
std::vector<SingleJointCorrection> computeJointCorrections(const Measurements& measurements,
                                                           const std::vector<PoseRows>& poses, Noise noise);

/// At the fit of the candidate tests.
std::vector<SingleJointCorrection> computeJointCorrections(const Measurements& measurements,
                                                           const CandidateTests& candidateTests);

} // namespace naocal

#pragma once

#include "diagnosis/evidence/CandidateTests.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// The deflection of one joint that alone would explain best what a model leaves over of some readings of a pose, all
/// encoders as noisy as they are:
///
///   a = -(J_t^T Sigma^-1 r) / (J_t^T Sigma^-1 J_t),  sigma = (J_t^T Sigma^-1 J_t)^-1/2
struct JointCorrection {
  std::vector<std::size_t> pictures; // that this encoder reading belongs to
  double deflection = 0, sigma = 0;  // [rad]
  double gradient = 0, gram = 0;     // of its corners: sum of w J_t^T r [px^2/rad], of w J_t^T J_t [px^2/rad^2]
};

/// Of one joint (motor), all poses one after the other.
struct SingleJointCorrection {
  std::size_t motor = 0;
  std::vector<JointCorrection> points;
};

/// Of each joint in use, where the residuals were linearised.
std::vector<SingleJointCorrection> computeJointCorrections(const Measurements& measurements,
                                                           const std::vector<PoseRows>& poses, Noise noise);

/// At an inquiry's fit.
std::vector<SingleJointCorrection> computeJointCorrections(const Measurements& measurements,
                                                           const CandidateTests& inquiry);

} // namespace naocal

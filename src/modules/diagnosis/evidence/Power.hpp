#pragma once

#include "inference/Evidence.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// All estimates within three of their sigmas.
bool isPlausible(const GroupEvidence& group, const Eigen::VectorXd& sigmas);

/// Chance that a candidate is noticed (p-value below `criticalP`) when its misfit has this noncentrality.
double detectionPower(double noncentrality, Eigen::Index freedom, double criticalP);

/// The noncentrality that is noticed with this chance.
double requiredNoncentrality(double power, Eigen::Index freedom, double criticalP);

/// What one candidate's captures can tell, from the information V = covariance^-1 of its unknowns.
struct Sensitivity {
  double power = 0;               // at the plausible size, of that unknown which is hardest to see
  std::vector<double> detectable; // per unknown: size that is noticed in 9 of 10 cases
};
Sensitivity computeSensitivity(const GroupEvidence& group, const Eigen::VectorXd& plausible, double criticalP);

} // namespace naocal

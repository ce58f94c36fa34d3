#pragma once

#include "inference/Evidence.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Whether all estimates lie within three prior sigmas.
bool isPlausible(const GroupEvidence& group, const Eigen::VectorXd& sigmas);

/// Detection probability (p-value below `criticalP`) at this noncentrality; 0 without degrees of freedom.
double detectionPower(double noncentrality, Eigen::Index freedom, double criticalP);

/// Detectability of a candidate, from the information V = covariance^-1 of its unknowns.
struct Sensitivity {
  double power = 0;               // at the plausible size of the unknown hardest to detect
  std::vector<double> detectable; // per unknown: size detected with 90 % power [the unknown's unit]
};
/// `plausible`: prior sigma of each unknown [the unknown's unit]; `criticalP`: p-value below which it is detected.
Sensitivity computeSensitivity(const GroupEvidence& group, const Eigen::VectorXd& plausible, double criticalP);

} // namespace naocal

#include "diagnosis/evidence/Power.hpp"
#include "inference/Thresholds.hpp"
#include "math/Statistics.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>
#include <limits>

namespace naocal {

bool isPlausible(const GroupEvidence& group, const Eigen::VectorXd& sigmas) {
  return (group.estimate.cwiseAbs().array() <= threshold::implausible * sigmas.array()).all();
}

double detectionPower(double noncentrality, Eigen::Index freedom, double criticalP) {
  if (freedom < 1) {
    return 0;
  }
  const boost::math::non_central_chi_squared shifted{static_cast<double>(freedom), std::min(noncentrality, 1e4)};
  return cdf(complement(shifted, criticalChi2(static_cast<double>(freedom), criticalP)));
}

Sensitivity computeSensitivity(const GroupEvidence& group, const Eigen::VectorXd& plausible, double criticalP) {
  const Eigen::Index count = plausible.size();
  Sensitivity result{0, std::vector<double>(static_cast<std::size_t>(count), std::numeric_limits<double>::infinity())};
  if (group.freedom < 1) {
    return result;
  }
  const Eigen::VectorXd information = group.covariance.inverse().diagonal();
  const double needed = requiredNoncentrality(0.9, static_cast<double>(group.freedom), criticalP);
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < count; ++i) {
    least = std::min(least, plausible[i] * plausible[i] * information[i]);
    result.detectable[static_cast<std::size_t>(i)] = std::sqrt(needed / information[i]);
  }
  result.power = detectionPower(least, group.freedom, criticalP);
  return result;
}

} // namespace naocal

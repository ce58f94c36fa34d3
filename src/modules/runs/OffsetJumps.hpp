#pragma once

#include "runs/Run.hpp"

#include <vector>

namespace naocal {

/// Chance that at least one joint is said to have jumped between two calibrations of a robot whose joints did not.
inline constexpr double jumpFalseAlarms = 0.01;

/// The change of a joint's offset between two calibrations.
struct OffsetChange {
  double value = 0;        // later minus earlier [rad]
  double sigma = 0;        // standard deviation of the difference [rad]
  double freedom = 0;      // degrees of freedom of its t distribution
  double chance = 1;       // two-sided p-value of this joint alone
  double familyChance = 1; // the same with all joints of this pair of calibrations considered
  bool isJump = false;     // familyChance <= jumpFalseAlarms
};

/// The change from one estimate to a later, independent one. With d = later - earlier, s^2 = sigma_1^2 + sigma_2^2:
///
///     chance = 2 P(T_nu <= -|d| / (s sqrt((nu - 2) / nu)))
///     nu = 4 + 2 / r,  r = (r_1 sigma_1^4 + r_2 sigma_2^4) / s^4,  r_i = 2 / (nu_i - 4)
///
/// Each estimate is normal with an uncertain variance, of relative variance r_i, written as the Student t of equal
/// variance and kurtosis (calibration/Uncertainty); variances add, and so do their uncertainties. The sigmas are those
/// of the results, widened by the misfit: what the model does not explain cannot pass for a jump.
/// Cf. Satterthwaite, "An approximate distribution of estimates of variance components", Biometrics Bulletin 2 (1946).
OffsetChange compareOffsets(const RunOffset& earlier, const RunOffset& later);

/// Sets `familyChance` and `isJump` of the changes of all joints between two calibrations: in ascending order of
/// `chance`, familyChance_(k) = max over j <= k of min(1, (m - j + 1) chance_(j)). Keeps the false alarms of the m
/// joints together at `jumpFalseAlarms`, however the estimates depend on each other. S. Holm, "A simple sequentially
/// rejective multiple test procedure", Scandinavian Journal of Statistics 6 (1979).
void findJumps(std::vector<OffsetChange>& changes);

} // namespace naocal

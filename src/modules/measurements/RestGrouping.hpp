#pragma once

#include "measurements/Measurements.hpp"

namespace naocal {

/// Sorts the pictures into a canonical order; groups those of one reading, and the readings of one pose. Readings of
/// one rest share each joint's encoder error and get the joint's most likely angle. Fills `poses`, `joints`, `jitter`,
/// `hasRepeats` and the observations' `repeats`; adds floor contact where both feet stand.
void groupByPose(Measurements& measurements);

/// Largest difference between readings of one rest, per joint [rad], [m]: 1.5 encoder steps plus what jitter exceeds
/// once in a million readings. Beyond it the robot moved. Requires `jitter`.
Eigen::ArrayXd restTolerance(const Measurements& measurements);

} // namespace naocal

#pragma once

#include "calibration/result/CalibrationResult.hpp"

#include <vector>

namespace naocal {

/// Tests whether the board views and readings of little or no weight (`outlierWeight`) share something. Accidents fall
/// on any pose and any board; what a missing effect moves far lies where its driver is.
///
/// Joints, time: rank correlation of each pose's share of rejected views with its angles, with their distance from the
/// median, with the direction of approach, and with time; null distribution by permutation of the poses. Boards,
/// cameras: number of poses in which each is rejected; by permutation of the views within each pose. The largest
/// statistic of each family counts (Westfall and Young, Resampling-based multiple testing, 1993), both families
/// together at `threshold::sharedCause`. Returns the causes beyond that level, most certain first.
std::vector<SharedCause> findSharedCauses(const Measurements& weighed);

} // namespace naocal

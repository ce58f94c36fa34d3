#pragma once

#include "measurements/Measurements.hpp"

namespace naocal {

/// Fills in directions of approach that no capture recorded, from the order of captures: the sign of a joint's change
/// since the capture before, by time within a set and by place in the file at equal times. Changes within the tolerance
/// of a rest (`restTolerance`) are none: the joint keeps its direction. A direction that was recorded stays.
///
/// Unknown, for a path between two captures that nobody knows, are the directions of
///   - the first capture, and of a joint that has not moved yet,
///   - the first capture of a stance, as the robot was put down by hand,
///   - a repeat that was approached anew with no other pose before it,
///   - a joint after a capture that did not record it,
/// and all of a set whose captures have one time: their order means nothing. Where at most 10 % of a joint's pictures,
/// those before the first motion aside, are unknown, they become 0, which moves nothing; else they stay NaN, and
/// effects of the approach are not tested there.
///
/// Requires `pictures` and `jitter`; counts `approachesFromOrder`.
void deriveApproaches(Measurements& measurements);

} // namespace naocal

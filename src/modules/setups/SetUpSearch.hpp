#pragma once

#include "calibration/result/CalibrationResult.hpp"

#include <vector>

namespace naocal {

/// Explains an error that no calibrated robot has by mistakes of the set-up (`allSetUps`), up to three together or
/// several wrong signs; empty if the error is none such, or if no mistake explains it.
///
/// Starts where the error of all measurements, those included that lost their weight, is ten times that of a usual
/// instrument, where an offset or a mount is off as on no robot, or where the likeliest effect is a scale. Each mistake
/// is undone in a part of the captures, fitted from the drawing; the likeliest then in all. A mistake is found if that
/// * shortens the description (`SetUpFit`) by more than 10 beyond its cost, 2 ln of the ways in which it could be made,
/// * and below that of any physical effect of a plausible size that the fit suspects,
/// * and takes the error to less than 0.4 of what it was, and to that of a robot.
/// Without a large error but with a far offset, a mistake that fits as well without such an offset is enough: the zero
/// of another joint, half a turn off, can be the same as an axis that points the other way.
std::vector<WrongSetUp> findSetUps(const FittedModel& fitted);

/// The same for captures that no fit is possible of.
std::vector<WrongSetUp> findSetUps(const Measurements& measurements, const Model& model);

/// Joints whose fitted offset lies nearer to a whole number of motor turns, not zero, than to zero.
std::vector<WrongSetUp> findSlippedCounts(const FittedModel& fitted);

} // namespace naocal

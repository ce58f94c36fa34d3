#pragma once

#include "calibration/ModelAverage.hpp"
#include "calibration/result/CalibrationResult.hpp"

#include <optional>

namespace naocal {

/// Fills `task` and `undetectable`: what the uncertainty means where the captures' result is used,
/// * with boards on the floor where a ball is seen 2 m ahead of the support foot, with the legs as captured and the
///   head straight, in the median capture. Tolerance: 50 mm;
/// * else where the tool is: a marker or frame in the tracker's frame, a marker at the place that it touches, or the
///   middle of a board in the camera's frame, in the capture that is predicted worst. Tolerance: 10 noise floors,
///   at most 5 mm.
///
/// Under each explanation the point's shift is a linear function of the own unknowns and of the explanation's effects:
/// a backlash that an offset imitates, or a step before the first joint that the tracker's place imitates, moves no
/// point that stands as in the captures. `sigma` [m] is the rms distance from where the fitted values put the point,
/// which are what a robot is given, added effects as in the point's capture; `bound` [m] is the root of the axes'
/// squared distances from there to the further end of the 99.95 % bound. `tolerance`: the user's [m], if any. Without
/// an average over models, bounds follow from the covariance. Nothing is filled where no point is measured; throws
/// InputError if a tolerance is given for it.
///
/// `undetectable`: the largest shift of the point by one effect that would not show (`ModelWindow::undetected`), else
/// of the joint offset that is shifted most.
void fillTask(const FittedModel& fitted, const ModelAverage* average, std::optional<double> tolerance,
              CalibrationResult& result);

} // namespace naocal

#pragma once

#include "calibration/Prediction.hpp"

namespace naocal {

/// Prints how well a result predicts captures: all of them, and by board and camera.
void printComparison(const Comparison& comparison);

/// Prints the errors of the poses that are predicted worst.
void printWorstPoses(const Comparison& comparison);

} // namespace naocal

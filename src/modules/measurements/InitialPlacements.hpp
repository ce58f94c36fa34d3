#pragma once

#include "measurements/Measurements.hpp"

#include <functional>
#include <string>

namespace naocal {

/// Estimates where things are that the sets do not place, from the measured angles and the drawing: boards in the world
/// or on a link and cameras beside the robot from the boards' poses in the pictures, trackers, markers, frames and
/// places from the readings, bases that were put down anew from boards. Sets the references that their unknown
/// placements count from, so that these stay small. What was not seen well enough keeps the reference that it has.
///
/// Only for robots with a URDF; placements of a NAO's sets count from zero or from their guesses.
///
/// `nameOf`: the name of something with an id in a set.
void placeInitially(Measurements& measurements,
                    const std::function<std::string(const CaptureSet&, std::string)>& nameOf);

} // namespace naocal

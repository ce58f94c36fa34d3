#pragma once

#include "residuals/Residuals.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// The pixel noise [px] that repeats show: how corners of one board move against each other between two pictures of one
/// pose, after the picture's rigid motion is taken out. No model of the robot enters. Absent without repeats.
std::optional<double> pixelNoiseFromRepeats(const Measurements& measurements,
                                            const std::vector<SightingResidual>& sightings);

/// The pixel noise [px] within single pictures: residuals after the picture's rigid motion is taken out. A lens or a
/// board that is not as believed counts as noise here. Absent where no picture shows enough corners (eight) of a board.
std::optional<double> pixelNoiseWithinPictures(const std::vector<SightingResidual>& sightings);

} // namespace naocal

#pragma once

#include "residuals/Places.hpp"

namespace naocal {

/// One capture of one of the sets in terms of the robot's joints, cameras and targets. `measurements` has its robot,
/// quantities and targets already.
/// Throws InputError for what the robot cannot have measured (unknown camera, no corners, joint needed but not
/// recorded).
Picture recordedPicture(const std::vector<CaptureSet>& sets, std::size_t set, std::size_t capture,
                        const Measurements& measurements, const Places& places);

} // namespace naocal

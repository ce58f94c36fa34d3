#pragma once

#include "calibrate/Calibration.hpp"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace naocal {

/// What of the captures does not fit the rest: set, capture, board, corners and how far off [px].
nlohmann::json doubtfulJson(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                            const CalibrationResult& result);

/// Every corner: measured; predicted with the joints' readings as they are; fitted, where the readings are moved as
/// far as their noise allows; and how far it counted.
nlohmann::json sightingsJson(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                             const CalibrationResult& result);

/// The cameras' image sizes, by set and name.
nlohmann::json camerasJson(const std::vector<CaptureSet>& sets);

} // namespace naocal

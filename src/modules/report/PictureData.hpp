#pragma once

#include "report/SeenPictures.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A number with as many decimals as a figure can show.
double withDecimals(double value, int decimals);

/// A picture's corners as figures show them [px]: per board `measured` (u, v of one corner after the other), how far
/// off they are predicted with the joints' readings as they are (`reported`) and with these moved as far as their
/// noise allows (`fitted`), and, where some count less, how far each counts (`weight`).
nlohmann::json pictureJson(const SeenPicture& seen);

} // namespace naocal

#pragma once

#include "io/JsonReader.hpp"
#include "report/SourceCaptures.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A result's estimates grouped by effect and unit, so that each group shares an axis. [{"title": "joint offset",
/// "unit": "°", "rows": [{"name": "LKneePitch", "value", "sigma", "low", "high", "learned", "far"}]}] with the standard
/// error, the ends of the 95 % interval, and what would move it far, or null.
nlohmann::json estimatesData(const JsonCursor& effects);

/// Data of a result page, in display units (degrees, millimetres, pixels): corners by picture, other readings by
/// instrument (`readingsOfResult`).
nlohmann::json resultData(const JsonCursor& result, const SourceCaptures& sources);

/// An image's corners for figures [px]: per board `measured` (u, v of all corners in sequence), the prediction error
/// with joint readings as they are (`reported`) and with readings adjusted within their noise (`fitted`), and, if some
/// corners are downweighted, each weight (`weight`).
nlohmann::json pictureJson(const PictureRecord& seen);

} // namespace naocal

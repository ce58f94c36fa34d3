#pragma once

#include "captures/JsonPlace.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A result's estimates by effect and unit: what can share an axis stands together. [{"title": "joint offset",
/// "unit": "°", "rows": [{"name": "LKneePitch", "value", "low", "high", "learned"}]}] with the ends of 95 % intervals.
nlohmann::json estimatesData(const JsonPlace& effects);

} // namespace naocal

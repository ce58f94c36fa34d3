#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A result's estimates by effect and unit: what can share an axis stands together. [{"title": "joint offset",
/// "unit": "°", "rows": [{"name": "LKneePitch", "value", "sigma", "low", "high", "learned"}]}] with the standard error
/// and the ends of the 95 % interval.
nlohmann::json estimatesData(const JsonPlace& effects);

} // namespace naocal

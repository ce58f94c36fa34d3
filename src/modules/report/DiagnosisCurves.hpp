#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A curve of a joint's deflection over a driver, in degrees, with the model file that proposes it as an effect beside
/// those that are `suggested`: it is what they leave.
nlohmann::json curveJson(const JsonPlace& curve, const nlohmann::json& suggested);

/// The cells of the joint x driver map, where the diagnosis has one.
nlohmann::json mapJson(const JsonPlace& diagnosis);

} // namespace naocal

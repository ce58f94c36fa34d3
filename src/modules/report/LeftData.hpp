#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Adds what a diagnosis's models leave over ("given", and "last" where something was added), in units that people
/// read: per joint the deflections that would explain it, and what stays within the pictures; and the drivers that were
/// recorded. What the file does not have stays empty or null. `data` has the pictures.
void addLeft(const JsonPlace& diagnosis, nlohmann::json& data);

} // namespace naocal

#pragma once

#include "diagnose/Figures.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Adds what was recorded at every picture, and what the models leave over: "asGiven" and, where something was added,
/// "withSuggested".
void addLeft(const Figures& figures, nlohmann::json& file);

} // namespace naocal

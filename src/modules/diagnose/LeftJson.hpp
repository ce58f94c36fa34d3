#pragma once

#include "diagnose/Figures.hpp"

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Adds what was recorded at every picture, and what the models leave over: "asGiven" and, where something was added,
/// "withSuggested". `mostPoints` as of `addFigures`.
void addLeft(const Figures& figures, std::size_t mostPoints, nlohmann::json& file);

} // namespace naocal

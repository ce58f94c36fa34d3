#pragma once

#include "diagnose/Diagnosis.hpp"

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace naocal {

/// What the diagnosis file holds for figures: numbers with as many digits as a figure can show.
///
/// `mostPoints`: of the points of one figure; where there are more, "of" says how many.
///
/// Adds poses, pictures and cameras, and how much alike candidates are, with each pair that the captures cannot tell
/// apart how many times as much data could.
void addFigures(const Diagnosis& diagnosis, std::size_t mostPoints, nlohmann::json& file);
/// Adds a candidate's figures.
void addFigures(const CandidateFinding& finding, std::size_t mostPoints, nlohmann::json& entry);

} // namespace naocal

#pragma once

#include "diagnosis/DiagnosisResult.hpp"

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Adds the figures to a diagnosis file, with as many digits as a figure can show: poses, pictures, cameras, residuals,
/// and the correlations of candidates; for each pair that the captures cannot distinguish, the factor of additional
/// data that could. `mostPoints`: upper limit per figure; if exceeded, "of" gives the full number.
void addFiguresJson(const Diagnosis& diagnosis, std::size_t mostPoints, nlohmann::json& file);

/// Adds the figures of a candidate.
void addFiguresJson(const CandidateFinding& finding, std::size_t mostPoints, nlohmann::json& entry);

} // namespace naocal

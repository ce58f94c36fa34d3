#pragma once

#include "judge/Tally.hpp"

namespace blind {

/// One self-contained HTML page with the required figures and four plots (SVG).
std::string renderEvaluation(const Tally& tally, const std::vector<Case>& cases);

} // namespace blind

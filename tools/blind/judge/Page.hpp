#pragma once

#include "judge/Tally.hpp"

namespace blind {

/// One HTML file with the required figures and five plots, drawn as SVG; nothing is loaded from anywhere.
std::string renderEvaluation(const Tally& tally, const std::vector<Case>& cases);

} // namespace blind

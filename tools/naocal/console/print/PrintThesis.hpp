#pragma once

#include "evaluation/thesis/ThesisTables.hpp"

namespace naocal {

/// Prints the thesis's tables with our results beside them, at the tolerance nearest to `degrees`, and a summary.
void printThesisTables(const ThesisEvaluation& evaluation, double degrees);

} // namespace naocal

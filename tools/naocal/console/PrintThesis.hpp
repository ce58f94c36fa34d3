#pragma once

#include "evaluation/ThesisTables.hpp"

namespace naocal {

/// Prints the thesis's tables with ours beside them, at the tolerance nearest to `degrees`, and what they come to.
void printThesisTables(const ThesisEvaluation& evaluation, double degrees);

} // namespace naocal

#pragma once

#include "evaluation/ThesisTables.hpp"

#include <functional>

namespace naocal {

/// Runs all settings of the tables that the evaluation does not hold yet, for the sets of its part, on several threads;
/// calls `keep` after each. Shows progress; stops early on Ctrl-C, with whole settings only.
void runThesis(ThesisEvaluation& evaluation, unsigned jobs, const std::function<void()>& keep);

} // namespace naocal

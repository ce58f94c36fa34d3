#pragma once

#include "poses/NextPoses.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Tells what a diagnosis leaves open and the command that proposes poses; or, where they were written to `file`, what
/// they are worth.
void printNext(const NextPoses& next, const std::vector<std::string>& sets, const std::string& file);

} // namespace naocal

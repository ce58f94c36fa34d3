#pragma once

#include "AsAsked.hpp"

#include "poses/NextPoses.hpp"

#include <string>

namespace naocal {

/// Tells what a diagnosis leaves open and the command that proposes poses; or, where they were written to `file`, what
/// they are worth.
void printNext(const NextPoses& next, AsAsked asked, const std::string& file);

} // namespace naocal

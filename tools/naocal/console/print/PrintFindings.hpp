#pragma once

#include "calibration/result/Finding.hpp"

#include <vector>

namespace naocal {

/// Prints the first finding's sentence, then the others with their levels; of what is weakly determined the first few.
void printFindings(const std::vector<Finding>& findings);

} // namespace naocal

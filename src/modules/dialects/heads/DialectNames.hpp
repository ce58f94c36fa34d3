#pragma once

#include <string>
#include <vector>

namespace naocal {

/// Names of the programs whose files `naocal import` reads.
std::vector<std::string> importedDialects();

/// Names of what `naocal export` writes: the imported ones, and `urdfDialect`.
std::vector<std::string> exportedDialects();

} // namespace naocal

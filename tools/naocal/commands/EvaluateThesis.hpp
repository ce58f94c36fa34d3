#pragma once

#include <string>
#include <vector>

namespace naocal {

/// Puts the parts of a thesis's evaluation together, writes them to `json` (empty: nowhere, "-": standard output only)
/// and prints their tables.
void mergeThesis(const std::vector<std::string>& files, const std::string& json);

} // namespace naocal

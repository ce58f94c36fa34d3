#pragma once

#include <string>
#include <vector>

namespace naocal {

/// Merges parts of a thesis evaluation, writes the result to `json` (empty: no file, "-": standard output only) and
/// prints its tables.
void mergeThesis(const std::vector<std::string>& files, const std::string& json);

} // namespace naocal

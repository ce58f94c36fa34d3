#pragma once

#include <string>
#include <vector>

namespace naocal {

/// Of the known names those that differ from `text` in the fewest letters, best first, for people who mistyped.
std::vector<std::string> nearNames(const std::string& text, const std::vector<std::string>& known,
                                   std::size_t most = 5);

} // namespace naocal

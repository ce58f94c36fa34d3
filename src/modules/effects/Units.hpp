#pragma once

#include <string_view>
#include <vector>

namespace naocal {

/// What unknowns may be counted in.
const std::vector<std::string_view>& units();
bool isUnit(std::string_view unit);

} // namespace naocal

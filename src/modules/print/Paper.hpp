#pragma once

#include <array>
#include <string_view>

namespace naocal {

/// A sheet of paper in landscape format, of the A series. Source: ISO 216.
struct Paper {
  std::string_view name;
  double width = 0, height = 0; // [mm]
};

inline constexpr std::array<Paper, 5> papers{
    {{"a4", 297, 210}, {"a3", 420, 297}, {"a2", 594, 420}, {"a1", 841, 594}, {"a0", 1189, 841}}};

/// The paper of a name such as "a3". Throws InputError for others.
const Paper& findPaper(std::string_view name);

} // namespace naocal

#pragma once

#include "writer/Design.hpp"
#include "writer/Drawing.hpp"

#include <filesystem>

namespace blind {

/// Writes what an item asks for: OUT/sets/NAME, OUT/locked/NAME (further poses of the same robot, never for choosing),
/// OUT/truth/NAME.sealed and, last, OUT/manifest/NAME.json with the sealed truth's hash. All of it follows from the
/// seed and the number.
void writeItem(const Drawing& drawing, const DesignItem& item, std::uint64_t seed, int number,
               const std::filesystem::path& out);

/// The name of the set of that number; tells nothing.
std::string setName(int number);

} // namespace blind

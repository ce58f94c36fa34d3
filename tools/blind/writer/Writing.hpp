#pragma once

#include "world/Drawing.hpp"
#include "writer/Design.hpp"

#include <filesystem>

namespace blind {

/// Writes an item: OUT/sets/NAME, OUT/locked/NAME (further poses of the same robot, never used for selection),
/// OUT/truth/NAME.sealed and, last, OUT/manifest/NAME.json with the hash of the sealed truth. Determined by seed and
/// number.
void writeItem(const Drawing& drawing, const DesignItem& item, std::uint64_t seed, int number,
               const std::filesystem::path& out);

/// Name of a set; does not reveal its contents.
std::string setName(int number);

/// Seals the truth of a set and lists the set in the manifest. `pictures`: it has images instead of corners.
void sealTruth(const std::string& truth, bool pictures, std::uint64_t seed, int number,
               const std::filesystem::path& out);

} // namespace blind

#pragma once

#include "writer/machines/WorkcellQuestion.hpp"

#include <cstdint>
#include <filesystem>

namespace blind {

/// Writes a set and its URDF, its sealed truth and its entry of the manifest into the folder.
void writeWorkcellItem(const WorkcellItem& item, std::uint64_t seed, int number, const std::filesystem::path& out);

} // namespace blind

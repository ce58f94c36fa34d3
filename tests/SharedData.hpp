#pragma once

#include "Skipped.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace naocal {

/// Folder or file of real measurements outside the project: ../shared/data beside the checkout. Absent: the caller
/// returns, and CTest reports the test as skipped, not passed.
inline std::optional<std::filesystem::path> sharedData(const std::string& inside) {
  const auto path = std::filesystem::path{NAOCAL_SOURCE_DIR} / ".." / "shared" / "data" / inside;
  if (std::filesystem::exists(path)) {
    return path;
  }
  skip("no ../shared/data/" + inside);
  return std::nullopt;
}

} // namespace naocal

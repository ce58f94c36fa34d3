#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <optional>
#include <string>

namespace naocal {

/// A folder or file of real measurements that are not part of the project: ../shared/data beside the checkout.
/// Tests that need it say so and pass where it is absent.
inline std::optional<std::filesystem::path> sharedData(const std::string& inside) {
  const auto path = std::filesystem::path{NAOCAL_SOURCE_DIR} / ".." / "shared" / "data" / inside;
  if (std::filesystem::exists(path)) {
    return path;
  }
  WARN("skipped: no ../shared/data/" + inside);
  return std::nullopt;
}

} // namespace naocal

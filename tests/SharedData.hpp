#pragma once

#include "Skipped.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace naocal {

/// A folder or file of real measurements that are not part of the project: ../shared/data beside the checkout.
/// Where it is absent the test is skipped: it returns, and CTest does not count it as passed.
inline std::optional<std::filesystem::path> sharedData(const std::string& inside) {
  const auto path = std::filesystem::path{NAOCAL_SOURCE_DIR} / ".." / "shared" / "data" / inside;
  if (std::filesystem::exists(path)) {
    return path;
  }
  skip("no ../shared/data/" + inside);
  return std::nullopt;
}

} // namespace naocal

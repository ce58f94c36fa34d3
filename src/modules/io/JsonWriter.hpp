#pragma once

#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

/// Writes JSON while preserving unknown keys that were read. (Heavy: include in .cpp files only.)

namespace naocal {

/// Rounds to significant digits. Five exceed the resolution of any figure and keep files small.
inline double roundToDigits(double value, int digits = 5) {
  assert(std::isfinite(value));
  if (value == 0) {
    return 0;
  }
  const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

/// The value of an optional or a pointer; null if it has none.
nlohmann::json orNull(const auto& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

/// The value read under a key, or null.
const nlohmann::json& childOrNull(const nlohmann::json& read, const std::string& key);

/// The entry of a list whose `key` has this value, or null.
const nlohmann::json& entryOrNull(const std::string& key, const nlohmann::json& value, const nlohmann::json& list);

/// Merges an object for writing: non-null keys of `known` in their order, then keys of `read` that are not in `known`.
nlohmann::ordered_json mergeUnknownKeys(const nlohmann::ordered_json& known, const nlohmann::json& read);

/// Formats the value on one line, with all digits of numbers; replaces invalid UTF-8.
std::string compactText(const nlohmann::ordered_json& value);

} // namespace naocal

#pragma once

#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

/// Writing JSON again without losing what was read beside the known keys. (Heavy: include in .cpp files only.)

namespace naocal {

/// Finer than any figure shows, and a file that stays small.
inline double roundToDigits(double value, int digits = 5) {
  assert(std::isfinite(value));
  if (value == 0) {
    return 0;
  }
  const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

/// What was read under a key; null when nothing was.
const nlohmann::json& childOrNull(const nlohmann::json& read, const std::string& key);

/// The entry of a list that was read whose `key` has this value; null when there is none.
const nlohmann::json& entryOrNull(const std::string& key, const nlohmann::json& value, const nlohmann::json& list);

/// An object as it is written: of the keys in `known` those that are not null, in their order, then those keys that
/// were read and are not in `known`.
nlohmann::ordered_json mergeUnknownKeys(const nlohmann::ordered_json& known, const nlohmann::json& read);

/// The value on one line. Numbers keep every digit; bytes that are not UTF-8 are replaced.
std::string compactText(const nlohmann::ordered_json& value);

} // namespace naocal

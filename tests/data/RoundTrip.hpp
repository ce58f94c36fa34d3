#pragma once

#include "data/CaptureSetFile.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

inline CaptureSet read(const nlohmann::json& document) {
  return parseCaptureSet(document.dump(), "set").set;
}

inline nlohmann::json written(const CaptureSet& set) {
  return nlohmann::json::parse(formatCaptureSet(set));
}

/// Whether `copy` contains everything in `original`; it may contain additional defaults.
inline bool holds(const nlohmann::json& copy, const nlohmann::json& original) {
  if (original.is_object()) {
    return copy.is_object() && std::all_of(original.items().begin(), original.items().end(), [&](const auto& item) {
             return copy.contains(item.key()) && holds(copy[item.key()], item.value());
           });
  }
  if (original.is_array()) {
    return copy.is_array() && copy.size() == original.size() &&
           std::equal(copy.begin(), copy.end(), original.begin(), holds);
  }
  return copy == original;
}

} // namespace naocal

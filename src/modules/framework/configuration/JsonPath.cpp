#include "framework/configuration/JsonPath.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using nlohmann::json;

json* descend(json& value, std::string_view path);

json* descendIndex(json& list, std::string_view path) { // path starts with '['
  const std::size_t close = path.find(']');
  std::size_t index = 0;
  if (close == std::string_view::npos) {
    return nullptr;
  }
  const auto [end, error] = std::from_chars(path.data() + 1, path.data() + close, index);
  if (error != std::errc{} || end != path.data() + close || !list.is_array() || index >= list.size()) {
    return nullptr;
  }
  return descend(list[index], path.substr(close + 1));
}

/// Resolves `path` from the longest matching key of `object`, with backtracking to shorter keys.
json* descendKey(json& object, std::string_view path, std::string* key) {
  if (!object.is_object()) {
    return nullptr;
  }
  for (std::size_t length = path.size(); length > 0; length = path.find_last_of(".[", length - 1)) {
    if (const auto entry = object.find(path.substr(0, length)); entry != object.end()) {
      if (json* place = descend(*entry, path.substr(length))) {
        if (key != nullptr) {
          *key = entry.key();
        }
        return place;
      }
    }
    if (path.find_last_of(".[", length - 1) == std::string_view::npos) {
      break;
    }
  }
  return nullptr;
}

json* descend(json& value, std::string_view path) {
  if (path.empty()) {
    return &value;
  }
  if (path.front() == '[') {
    return descendIndex(value, path);
  }
  return path.front() == '.' ? descendKey(value, path.substr(1), nullptr) : nullptr;
}

} // namespace

JsonPathTarget resolvePath(json& object, std::string_view path) {
  JsonPathTarget place;
  place.value = descendKey(object, path, &place.topLevelKey);
  return place;
}

} // namespace naocal

#include "io/JsonWriter.hpp"

namespace naocal {
namespace {

const nlohmann::json nothing;

} // namespace

const nlohmann::json& childOrNull(const nlohmann::json& read, const std::string& key) {
  const auto entry = read.find(key);
  return entry == read.end() ? nothing : *entry;
}

const nlohmann::json& entryOrNull(const std::string& key, const nlohmann::json& value, const nlohmann::json& list) {
  for (const nlohmann::json& entry : list) {
    if (childOrNull(entry, key) == value) {
      return entry;
    }
  }
  return nothing;
}

nlohmann::ordered_json mergeUnknownKeys(const nlohmann::ordered_json& known, const nlohmann::json& read) {
  auto object = nlohmann::ordered_json::object();
  for (const auto& [key, value] : known.items()) {
    if (!value.is_null()) {
      object[key] = value;
    }
  }
  if (read.is_object()) {
    for (const auto& [key, value] : read.items()) {
      if (!known.contains(key)) {
        object[key] = value;
      }
    }
  }
  return object;
}

std::string compactText(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace naocal

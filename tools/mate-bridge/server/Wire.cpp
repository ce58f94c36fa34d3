#include "server/Wire.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

std::string wireText(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json wireJson(std::string_view text) {
  constexpr int deepest = 100;
  return json::parse(text, [](int depth, json::parse_event_t, json&) {
    if (depth > deepest) {
      throw json::out_of_range::create(0, "expected at most 100 levels of brackets, found more", nullptr);
    }
    return true;
  });
}

} // namespace naocal

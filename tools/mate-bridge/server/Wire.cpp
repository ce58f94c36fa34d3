#include "server/Wire.hpp"

#include <charconv>
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

std::string withoutPercents(std::string_view path) {
  std::string plain;
  for (std::size_t i = 0; i < path.size(); ++i) {
    unsigned char byte = 0;
    const char* const code = path.data() + i + 1;
    if (path[i] == '%' && i + 2 < path.size() && std::from_chars(code, code + 2, byte, 16).ptr == code + 2) {
      plain += static_cast<char>(byte);
      i += 2;
    } else {
      plain += path[i];
    }
  }
  return plain;
}

} // namespace naocal

#include "protocol/BoundedJson.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr int deepest = 100;

} // namespace

nlohmann::json parseBoundedJson(std::string_view text, bool withComments) {
  using Event = nlohmann::json::parse_event_t;
  const auto shallow = [](int depth, Event event, nlohmann::json&) { // depth: brackets around the present ones
    if (depth >= deepest && (event == Event::array_start || event == Event::object_start)) {
      throw nlohmann::json::out_of_range::create(0, "expected at most 100 levels of brackets, found more", nullptr);
    }
    return true;
  };
  return nlohmann::json::parse(text, shallow, true, withComments);
}

std::string parseErrorReason(const std::exception& error) {
  const std::string_view message = error.what(); // "[json.exception.type_error.302] type must be string, but is ..."
  const std::size_t mark = message.rfind("[json.exception", 0) == 0 ? message.find("] ") : std::string_view::npos;
  return std::string{message.substr(mark == std::string_view::npos ? 0 : mark + 2)};
}

std::string jsonText(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string jsonLine(const nlohmann::json& value) {
  return jsonText(value) + "\n";
}

} // namespace naocal

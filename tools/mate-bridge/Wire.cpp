#include "Wire.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

std::string wireText(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace naocal

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace naocal {

/// JSON as it goes to a panel or a robot, whatever bytes its texts hold.
std::string wireText(const nlohmann::json& json);

/// What came as JSON. Throws nlohmann::json::exception; also for brackets so deep that writing them again could exhaust
/// the stack.
nlohmann::json wireJson(std::string_view text);

} // namespace naocal

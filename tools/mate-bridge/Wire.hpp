#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// JSON as it goes to a panel or a robot, whatever bytes its texts hold.
std::string wireText(const nlohmann::json& json);

} // namespace naocal

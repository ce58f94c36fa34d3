#pragma once

#include "runs/RobotHistory.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// HISTORY.json (`naocal-history`): the runs of robots with their sentences, and the offsets of each joint over time
/// with the changes and jumps; angles in radians, times in UTC. `folder`: where the runs are recorded; `broken`: a
/// sentence for each file that is no run.
nlohmann::json historyJson(const std::vector<RobotHistory>& histories, const std::string& folder,
                           const std::vector<std::string>& broken);

} // namespace naocal

#pragma once

#include "data/Capture.hpp"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace naocal {

/// The boards on the floor, as a capture set describes them.
struct CalibrationBoards {
  std::vector<Board> boards;
};
/// Throws InputError that says which entry is wrong and how.
void from_json(const nlohmann::json& json, CalibrationBoards& boards);

} // namespace naocal

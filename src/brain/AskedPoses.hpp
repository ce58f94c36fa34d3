#pragma once

#include "data/Capture.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Poses that a person asks a robot to take: a pose file's content. What is in it is checked when it is played.
struct AskedPoses {
  std::string content;
  std::vector<SupportFoot> feet; // that its poses stand on, left before right; none: it has no poses on one foot
};
void from_json(const nlohmann::json& json, AskedPoses& poses);

} // namespace naocal

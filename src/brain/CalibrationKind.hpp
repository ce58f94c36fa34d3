#pragma once

#include "data/Capture.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// What can be calibrated at once.
struct CalibrationKind {
  std::string run;               // the value of the parameter `run` that starts it
  std::string title, sentence;   // for people
  std::vector<SupportFoot> feet; // that the robot stands on, one after the other: both at once, or one foot
};
void to_json(nlohmann::json& out, const CalibrationKind& kind);

/// In the order to offer them.
const std::vector<CalibrationKind>& calibrationKinds();

/// nullptr: there is none of that name.
const CalibrationKind* calibrationKind(std::string_view run);

} // namespace naocal

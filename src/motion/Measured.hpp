#pragma once

#include "hardware/RobotInterface.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// What the robot has reported last; `isNew` in the cycle in which it came.
struct Measured {
  bool isNew = false;
  RobotState state;
};
void to_json(nlohmann::json& out, const Measured& measured);
void to_json(nlohmann::json& out, const RobotLink& link);

} // namespace naocal

#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Where somebody wants the robot to look from its stand, while nothing is calibrated.
struct HeadLookRequest {
  bool active = false;
  double yaw = 0, pitch = 0; // [deg]
  bool operator==(const HeadLookRequest&) const = default;
};
void to_json(nlohmann::json& out, const HeadLookRequest& look);

/// What HULKs' panel sets to have the robot look around, under its names.
class BehaviorModule final : public Module {
public:
  BehaviorModule() : Module{"BehaviorModule"} {}
  void cycle() override { look_.edit(); }
  void onParametersChanged() override { look_ = {*active_, *yaw_, *pitch_}; }

private:
  CommandParameter<bool> active_{*this, "isCameraCalibration"};
  Parameter<double> yaw_{*this, "calibrationHeadYaw"}, pitch_{*this, "calibrationHeadPitch"}; // [deg]
  Parameter<bool> unused_{*this, "useEffectiveYawVelocity"}; // the panel sets it; nothing depends on it
  Production<HeadLookRequest> look_{*this, "wantedLook"};
};

} // namespace naocal

#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Head orientation requested while no calibration runs.
struct HeadLookRequest {
  bool active = false;
  double yaw = 0, pitch = 0; // [deg]
  bool operator==(const HeadLookRequest&) const = default;
};
void to_json(nlohmann::json& out, const HeadLookRequest& look);

/// Receives head look requests from HULKs' panel, under the panel's parameter names.
class BehaviorModule final : public Module {
public:
  BehaviorModule() : Module{"BehaviorModule"} {}
  void cycle() override { look_.edit(); }
  void onParametersChanged() override { look_ = {*active_, *yaw_, *pitch_}; }

private:
  CommandParameter<bool> active_{*this, "isCameraCalibration"};
  Parameter<double> yaw_{*this, "calibrationHeadYaw"}, pitch_{*this, "calibrationHeadPitch"}; // [deg]
  Parameter<bool> unused_{*this, "useEffectiveYawVelocity"}; // set by the panel, not used
  Production<HeadLookRequest> look_{*this, "wantedLook"};
};

} // namespace naocal

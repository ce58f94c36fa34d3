#pragma once

#include "data/Capture.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// What is believed of one camera.
struct CameraModel {
  CameraIntrinsics intrinsics;
  std::array<double, 3> rotation{}; // of its mount beyond the drawing: rx, ry, rz in the camera's axes [rad]
};
using CameraModels = std::map<std::string, CameraModel>; // "top", "bottom"
void to_json(nlohmann::json& out, const CameraModel& belief);

/// The cameras' calibration as HULKs keep it in Projection.json: focal length and centre as shares of the picture's
/// width and height, the mount's rotation as roll, pitch, yaw in radians.
class Projection final : public Module {
public:
  Projection() : Module{"Projection"} {}
  void cycle() override { beliefs_.edit(); }
  void onParametersChanged() override;

private:
  Parameter<std::array<double, 3>> topRotation_{*this, "top_ext"}, bottomRotation_{*this, "bottom_ext"}; // [rad]
  Parameter<std::array<double, 2>> topFocal_{*this, "top_fc"}, bottomFocal_{*this, "bottom_fc"};         // [1]
  Parameter<std::array<double, 2>> topCentre_{*this, "top_cc"}, bottomCentre_{*this, "bottom_cc"};       // [1]
  Production<CameraModels> beliefs_{*this, "cameras"};
};

} // namespace naocal

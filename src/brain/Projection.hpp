#pragma once

#include "data/Capture.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// Calibration of one camera.
struct CameraModel {
  CameraIntrinsics intrinsics;
  std::array<double, 3> rotation{}; // mount rotation relative to the drawing: rx, ry, rz in the camera's axes [rad]
};
using CameraModels = std::map<std::string, CameraModel>; // "top", "bottom"
void to_json(nlohmann::json& out, const CameraModel& modelState);

/// Camera calibration in HULKs' format (Projection.json): focal length and principal point as fractions of image width
/// and height, mount rotation as roll, pitch, yaw [rad].
class Projection final : public Module {
public:
  Projection() : Module{"Projection"} {}
  void cycle() override { cameraModels_.edit(); }
  void onParametersChanged() override;

private:
  Parameter<std::array<double, 3>> topRotation_{*this, "top_ext"}, bottomRotation_{*this, "bottom_ext"}; // [rad]
  Parameter<std::array<double, 2>> topFocal_{*this, "top_fc"}, bottomFocal_{*this, "bottom_fc"};         // [1]
  Parameter<std::array<double, 2>> topCentre_{*this, "top_cc"}, bottomCentre_{*this, "bottom_cc"};       // [1]
  Production<CameraModels> cameraModels_{*this, "cameras"};
};

} // namespace naocal

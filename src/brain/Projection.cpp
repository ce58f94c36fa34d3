#include "brain/Projection.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

CameraModel modelState(const std::array<double, 3>& rotation, const std::array<double, 2>& focal,
                       const std::array<double, 2>& centre) {
  CameraModel result{{}, rotation};
  CameraIntrinsics& lens = result.intrinsics;
  lens.fx = focal[0] * lens.width;
  lens.fy = focal[1] * lens.height;
  lens.cx = centre[0] * lens.width;
  lens.cy = centre[1] * lens.height;
  return result;
}

} // namespace

void Projection::onParametersChanged() {
  cameraModels_ = {{"top", modelState(*topRotation_, *topFocal_, *topCentre_)},
                   {"bottom", modelState(*bottomRotation_, *bottomFocal_, *bottomCentre_)}};
}

void to_json(nlohmann::json& out, const CameraModel& modelState) {
  out = {{"fc", {modelState.intrinsics.fx, modelState.intrinsics.fy}},
         {"cc", {modelState.intrinsics.cx, modelState.intrinsics.cy}},
         {"ext", modelState.rotation}};
}

} // namespace naocal

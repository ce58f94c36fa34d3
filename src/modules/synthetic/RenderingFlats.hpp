#pragma once

#include "synthetic/Rendering.hpp"

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace naocal {

/// A flat thing made ready: where a ray meets its plane, what is painted there, and which pixels it may touch.
struct Flat {
  Eigen::Matrix3f planeFromRay;                  // (x, y, 1) / distance = planeFromRay * ray
  std::function<float(float, float)> brightness; // at x, y of its frame [m]; negative: beyond its edge
  int left, right, top, bottom;                  // [px], inclusive
};

/// All flat things of a scene, those in front first.
std::vector<Flat> flats(const RenderedScene& scene, const CameraIntrinsics& camera);

} // namespace naocal

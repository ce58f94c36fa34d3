#pragma once

#include "synthetic/Painting.hpp"
#include "synthetic/Rendering.hpp"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace naocal {

/// A flat thing made ready: what is painted on it, which pixels it may touch, and where a ray meets its plane.
struct Flat {
  std::shared_ptr<const Painting> painting;
  bool fromBehind = false;                   // as seen at the first instant
  int left, right, top, bottom;              // [px], inclusive, at all instants
  std::vector<Eigen::Matrix3f> planeFromRay; // by instant: (x, y, 1) / distance = planeFromRay * ray

  /// At a share of the span between the first and the last instant.
  Eigen::Matrix3f at(float share) const;
};

/// All flat things of a scene at several instants, those in front first.
std::vector<Flat> flats(const std::vector<RenderedScene>& scenes, const CameraIntrinsics& camera);

} // namespace naocal

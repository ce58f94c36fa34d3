#pragma once

#include "residuals/Measurements.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// What one picture should show of one board if everything were as believed.
struct SceneBoard {
  Eigen::Matrix2Xd corners; // [px]; not finite where one would lie behind the camera
  RigidTransform opticalFromBoard;

  /// Of the board's origin from the camera [m].
  double distance() const { return opticalFromBoard.translation.norm(); }
};

/// Of all sightings of a picture, in their order.
std::vector<SceneBoard> scene(const Measurements& measurements, const Picture& picture, const Belief& belief);

} // namespace naocal

#pragma once

#include "evaluation/thesis/SoleCamera.hpp"
#include "math/Sampling.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// Errors of held-out poses, as the thesis's own program judges a calibration.
struct HeldOutError {
  double mean = 0;                 // distance of the points from their predictions [px]
  double norm = 0, normAtZero = 0; // root of the sum of squares, at the estimate and at zero offsets [px]
  std::size_t points = 0;

  /// At most `programTestTolerance`, and no worse than without a calibration.
  bool isAcceptable() const;
};

/// Poses that are not used for the calibration; a robot with joint offsets sees floor points in them.
class HeldOutPoses {
public:
  /// `poses`: angles per joint of the camera's chain [rad]; `points`: on the floor, in the sole's frame [m]. Keeps a
  /// reference to the camera.
  HeldOutPoses(const SoleCamera<double>& camera, std::vector<Eigen::VectorXd> poses, Eigen::Matrix2Xd points)
      : camera_{camera}, poses_{std::move(poses)}, points_{std::move(points)} {}

  /// Noise of the pictures, 1 sigma: of angles [rad] and pixels [px].
  struct Scatter {
    double angle = 0, pixel = 0;
  };

  /// Takes the pictures of a robot with these offsets, true angle = reading - offset.
  void draw(const Eigen::VectorXd& offsets, const Scatter& scatter, RandomStream& chance);

  HeldOutError error(const Eigen::VectorXd& estimate) const;

private:
  struct Picture {
    std::size_t pose = 0;
    Eigen::Matrix2Xd points, pixels;
  };
  double sumOfDistances(const Eigen::VectorXd& offsets, double& squares) const;

  const SoleCamera<double>& camera_;
  std::vector<Eigen::VectorXd> poses_;
  Eigen::Matrix2Xd points_;
  std::vector<Picture> pictures_;
};

/// The floor points that lie in the image of a camera, and their pixels.
struct PointsInImage {
  Eigen::Matrix2Xd points, pixels;
};
PointsInImage pointsInImage(const SoleCamera<double>& camera, const SoleCamera<double>::Transform& cameraFromSole,
                            const Eigen::Matrix2Xd& points);

} // namespace naocal

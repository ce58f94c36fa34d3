#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

namespace naocal {

/// A camera of the drawn robot above one of its soles: the kinematic chain between them and the pinhole projection, in
/// single or double precision. Rotations are kept as axis and angle and multiplied as quaternions, like those of the
/// HULKs' KinematicMatrix, which the thesis's program uses: in single precision it rounds as that program does. Camera
/// axes: x forward (optical axis), y left, z up. Floor points are (x, y) in the sole's frame [m].
template <typename Scalar> class SoleCamera {
public:
  using Angles = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>; // true angles, one per motor [rad]
  using Points = Eigen::Matrix<Scalar, 2, Eigen::Dynamic>; // floor points [m] or pixels [px], one per column
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  struct Transform {
    Eigen::AngleAxis<Scalar> rotation = Eigen::AngleAxis<Scalar>::Identity();
    Vector3 translation = Vector3::Zero(); // [m]

    Transform operator*(const Transform& other) const {
      return {Eigen::AngleAxis<Scalar>{rotation * other.rotation}, rotation * other.translation + translation};
    }
    Transform inverse() const { return {rotation.inverse(), rotation.inverse() * -translation}; }
  };

  /// `motors`: joints of `Angles`. All other joints are at zero. Without lens distortion.
  SoleCamera(const Robot& robot, std::size_t camera, std::size_t soleLink, const std::vector<std::size_t>& motors,
             const CameraIntrinsics& lens);

  Transform cameraFromSole(const Angles& angles) const;

  /// Pixels of floor points, unlimited by the image; (0, 0) for points behind the camera, as the thesis's program has
  /// it.
  void project(const Transform& cameraFromSole, const Points& points, Points& pixels) const;

  /// Where the ray of a pixel meets the floor; absent if it points at or above the horizon.
  std::optional<Eigen::Matrix<Scalar, 2, 1>> floorPoint(const Transform& cameraFromSole, Scalar u, Scalar v) const;

  const CameraIntrinsics& lens() const { return lens_; }

private:
  struct Step {
    Vector3 origin, axis;             // [m], unit vector
    std::optional<std::size_t> motor; // index into `Angles`; absent: the joint does not move
  };

  std::vector<Step> stepsTo(const Robot& robot, std::size_t link, const std::vector<std::size_t>& motors) const;
  static Transform torsoFromEnd(const std::vector<Step>& steps, const Angles& angles);

  CameraIntrinsics lens_;
  std::vector<Step> toSole_, toHead_; // root first
  Transform headFromCamera_;
};

/// Whether the thesis's program uses a pixel: not beyond the image, and in front of the camera.
inline bool isInImage(const CameraIntrinsics& lens, const Eigen::Vector2d& pixel) {
  return pixel.minCoeff() > 0 && pixel.x() <= lens.width && pixel.y() <= lens.height;
}

/// Floor seen by a camera, as far as `farthest` from the sole [m]: near left, far left, far right, near right corner
/// [m]. Absent if the near corners lie beyond.
std::optional<std::array<Eigen::Vector2d, 4>>
fieldOfView(const SoleCamera<double>& camera, const SoleCamera<double>::Transform& cameraFromSole, double farthest);

extern template class SoleCamera<float>;
extern template class SoleCamera<double>;

} // namespace naocal

#include "evaluation/thesis/SoleCamera.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>

namespace naocal {

namespace {

Eigen::Vector3d drawnOrigin(const Robot& robot, const Link& link) {
  Eigen::Vector3d origin = link.constant;
  for (const Link::Stretch& stretch : link.stretches) {
    origin += robot.lengths[stretch.length].value * stretch.direction;
  }
  return origin;
}

/// The point of an image's left or right border, from its lower end upwards, that is farthest on the floor but within
/// reach.
std::optional<Eigen::Vector2d> farthestOnBorder(const SoleCamera<double>& camera,
                                                const SoleCamera<double>::Transform& cameraFromSole, double u,
                                                double farthest) {
  std::optional<Eigen::Vector2d> last;
  for (int v = camera.lens().height - 1; v >= 0; v -= 4) {
    const auto point = camera.floorPoint(cameraFromSole, u, v);
    if (!point || point->norm() > farthest) {
      break;
    }
    last = point;
  }
  return last;
}

} // namespace

template <typename Scalar>
SoleCamera<Scalar>::SoleCamera(const Robot& robot, std::size_t camera, std::size_t soleLink,
                               const std::vector<std::size_t>& motors, const CameraIntrinsics& lens)
    : lens_{lens}, toSole_{stepsTo(robot, soleLink, motors)}, toHead_{
                                                                  stepsTo(robot, robot.cameras[camera].link, motors)} {
  const CameraMount& mount = robot.cameras[camera];
  headFromCamera_ = {Eigen::AngleAxisd{mount.rotation}.template cast<Scalar>(), mount.translation.cast<Scalar>()};
}

template <typename Scalar>
std::vector<typename SoleCamera<Scalar>::Step>
SoleCamera<Scalar>::stepsTo(const Robot& robot, std::size_t link, const std::vector<std::size_t>& motors) const {
  std::vector<Step> steps;
  for (std::optional<std::size_t> at = link; at && robot.links[*at].parent; at = robot.links[*at].parent) {
    const Link& here = robot.links[*at];
    Step step{drawnOrigin(robot, here).cast<Scalar>(), Vector3::UnitX(), std::nullopt};
    if (here.joint) {
      const Joint& joint = robot.joints[*here.joint];
      step.axis = joint.axis.cast<Scalar>();
      if (const auto motor = std::find(motors.begin(), motors.end(), joint.motor); motor != motors.end()) {
        step.motor = static_cast<std::size_t>(motor - motors.begin());
      }
    }
    steps.push_back(step);
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

template <typename Scalar>
typename SoleCamera<Scalar>::Transform SoleCamera<Scalar>::torsoFromEnd(const std::vector<Step>& steps,
                                                                        const Angles& angles) {
  Transform result;
  for (const Step& step : steps) {
    const Scalar angle = step.motor ? angles[eigenIndex(*step.motor)] : Scalar{0};
    result = result * Transform{Eigen::AngleAxis<Scalar>(angle, step.axis), step.origin};
  }
  return result;
}

template <typename Scalar>
typename SoleCamera<Scalar>::Transform SoleCamera<Scalar>::cameraFromSole(const Angles& angles) const {
  const Transform soleFromCamera =
      torsoFromEnd(toSole_, angles).inverse() * (torsoFromEnd(toHead_, angles) * headFromCamera_);
  return soleFromCamera.inverse();
}

template <typename Scalar>
void SoleCamera<Scalar>::project(const Transform& cameraFromSole, const Points& points, Points& pixels) const {
  const auto fx = static_cast<Scalar>(lens_.fx), fy = static_cast<Scalar>(lens_.fy);
  const auto cx = static_cast<Scalar>(lens_.cx), cy = static_cast<Scalar>(lens_.cy);
  const Eigen::Matrix<Scalar, 3, 2> axes = cameraFromSole.rotation.toRotationMatrix().template leftCols<2>();
  pixels.resize(2, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Vector3 point = axes * points.col(i) + cameraFromSole.translation;
    if (point.x() > 0) {
      pixels.col(i) << cx - fx * point.y() / point.x(), cy - fy * point.z() / point.x();
    } else {
      pixels.col(i).setZero();
    }
  }
}

template <typename Scalar>
std::optional<Eigen::Matrix<Scalar, 2, 1>> SoleCamera<Scalar>::floorPoint(const Transform& cameraFromSole, Scalar u,
                                                                          Scalar v) const {
  const Vector3 ray{1, (static_cast<Scalar>(lens_.cx) - u) / static_cast<Scalar>(lens_.fx),
                    (static_cast<Scalar>(lens_.cy) - v) / static_cast<Scalar>(lens_.fy)};
  const Transform soleFromCamera = cameraFromSole.inverse();
  const Vector3 direction = soleFromCamera.rotation * ray, camera = soleFromCamera.translation;
  if (direction.z() >= 0 || camera.z() <= 0) {
    return std::nullopt;
  }
  return (camera - camera.z() / direction.z() * direction).template head<2>();
}

template class SoleCamera<float>;
template class SoleCamera<double>;

std::optional<std::array<Eigen::Vector2d, 4>>
fieldOfView(const SoleCamera<double>& camera, const SoleCamera<double>::Transform& cameraFromSole, double farthest) {
  const double right = camera.lens().width - 1, lower = camera.lens().height - 1;
  const auto farLeft = farthestOnBorder(camera, cameraFromSole, 0, farthest);
  const auto farRight = farthestOnBorder(camera, cameraFromSole, right, farthest);
  if (!farLeft || !farRight) {
    return std::nullopt;
  }
  return std::array{*camera.floorPoint(cameraFromSole, 0, lower), *farLeft, *farRight,
                    *camera.floorPoint(cameraFromSole, right, lower)};
}

} // namespace naocal

#include "dialects/heads/HeadCamera.hpp"

#include "dialects/MountAngles.hpp"
#include "io/InputError.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace naocal {

namespace {

const CameraMount& findCarried(const Robot& robot, const std::string& name) {
  std::vector<std::string> names;
  const CameraMount* found = nullptr;
  for (const CameraMount& mount : robot.cameras) {
    if (!mount.inWorld) {
      names.push_back(mount.name);
      found = name.empty() || mount.name == name ? &mount : found;
    }
  }
  if (found == nullptr || (name.empty() && names.size() > 1)) {
    throw InputError{fmt::format("--camera: expected {} that the robot carries{}, found {}",
                                 names.size() > 1 ? "one of the cameras" : "a camera",
                                 names.empty() ? "" : fmt::format(" ({})", fmt::join(names, ", ")),
                                 name.empty() ? "none" : fmt::format("\"{}\"", name))};
  }
  return *found;
}

/// parentFromLink without the joint's motion.
RigidTransform fixedStep(const Robot& robot, const Link& link) {
  RigidTransform step{link.rotation.value_or(Eigen::Matrix3d::Identity()), link.constant};
  for (const Link::Stretch& stretch : link.stretches) {
    step.translation += robot.lengths[stretch.length].value * stretch.direction;
  }
  return step;
}

struct PlaceOnLink {
  std::size_t link;
  RigidTransform transform; // linkFromThing
};

/// From a place on a link up to the next link that a joint moves, or to the root.
PlaceOnLink climbFixed(const Robot& robot, PlaceOnLink place) {
  while (!robot.links[place.link].joint && robot.links[place.link].parent) {
    place.transform = fixedStep(robot, robot.links[place.link]) * place.transform;
    place.link = *robot.links[place.link].parent;
  }
  return place;
}

std::optional<double> offsetOf(const RobotCalibration& calibration, const std::string& joint) {
  const auto found = calibration.offsets.find(joint);
  return found == calibration.offsets.end() ? std::nullopt : std::optional{found->second};
}

std::optional<HeadCamera::BaseJoint> findBase(const Robot& robot, std::size_t neck,
                                              const RobotCalibration& calibration) {
  const Link& neckLink = robot.links[neck];
  const PlaceOnLink below = climbFixed(robot, {*neckLink.parent, fixedStep(robot, neckLink)});
  const auto index = robot.links[below.link].joint;
  if (!index || robot.joints[*index].isPrismatic) {
    return std::nullopt;
  }
  const PlaceOnLink root =
      climbFixed(robot, {*robot.links[below.link].parent, fixedStep(robot, robot.links[below.link])});
  if (robot.links[root.link].joint) {
    return std::nullopt; // a further joint below: no fixed axis
  }
  const Joint& joint = robot.joints[*index];
  return HeadCamera::BaseJoint{joint.name, root.transform.rotation * joint.axis, offsetOf(calibration, joint.name)};
}

} // namespace

HeadCamera describeHeadCamera(const Robot& robot, const std::string& camera, const RobotCalibration& calibration) {
  const CameraMount& mount = findCarried(robot, camera);
  const PlaceOnLink carrier = climbFixed(robot, {mount.link, {}});
  const auto index = robot.links[carrier.link].joint;
  if (!index || robot.joints[*index].isPrismatic) {
    throw InputError{fmt::format("camera {}: expected one on a head that a joint turns, found one on {}", mount.name,
                                 robot.links[carrier.link].name)};
  }
  const Joint& joint = robot.joints[*index];
  HeadCamera head;
  head.name = mount.name;
  head.neckJoint = joint.name;
  head.neckLink = robot.links[carrier.link].name;
  head.neckAxis = joint.axis;
  const std::optional<double> neckOffset = offsetOf(calibration, joint.name);
  head.neckOffset = neckOffset.value_or(0);
  head.drawn = carrier.transform * RigidTransform{mount.rotation, mount.translation};
  const auto found = calibration.cameras.find(mount.name);
  const CameraCalibration own = found == calibration.cameras.end() ? CameraCalibration{} : found->second;
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  if (own.rotation || neckOffset) {
    head.calibrated = RigidTransform{rotationAbout(-head.neckOffset * joint.axis), zero} * carrier.transform *
                      RigidTransform{mount.rotation * rotationXyz(own.rotation.value_or(zero)),
                                     mount.translation + own.translation.value_or(zero)};
  }
  head.base = findBase(robot, carrier.link, calibration);
  return head;
}

RigidTransform placeOnNeck(const Robot& robot, const HeadCamera& head, const std::string& link) {
  const auto index = robot.linkIndex(link);
  const PlaceOnLink place = index ? climbFixed(robot, {*index, {}}) : PlaceOnLink{};
  if (!index || robot.links[place.link].name != head.neckLink) {
    throw InputError{fmt::format("the URDF: expected a link {} that is fixed to {}, as the camera {} is; found none",
                                 link, head.neckLink, head.name)};
  }
  return place.transform;
}

RobotCalibration calibrationFromDirection(const HeadCamera& head, const Eigen::Matrix3d& neckFromCamera,
                                          std::optional<double> baseOffset) {
  RobotCalibration calibration;
  calibration.cameras[head.name].rotation = anglesXyz(head.drawn.rotation.transpose() * neckFromCamera);
  if (head.base && baseOffset) {
    calibration.offsets[head.base->name] = *baseOffset;
  }
  return calibration;
}

void requireAxis(const Eigen::Vector3d& axis, const Eigen::Vector3d& expected, const std::string& joint,
                 const std::string& file) {
  if ((axis - expected).norm() > 1e-6) {
    throw InputError{fmt::format("{}: expected a joint about ({}, {}, {}), as the robot of this file has it; found {} "
                                 "about ({:.3f}, {:.3f}, {:.3f})",
                                 file, expected.x(), expected.y(), expected.z(), joint, axis.x(), axis.y(), axis.z())};
  }
}

} // namespace naocal

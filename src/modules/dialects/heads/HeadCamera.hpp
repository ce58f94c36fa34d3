#pragma once

#include "dialects/RobotCalibration.hpp"
#include "math/RigidTransform.hpp"
#include "robot/Robot.hpp"

#include <optional>
#include <string>

namespace naocal {

/// Where a camera on a robot's head looks, with what other programs correct: the camera's rotation behind the last
/// joint of the neck. That joint's offset turns the camera alike at all angles and is part of it:
///
///   neckFromCamera = R(axis, -offset) * neckFromCarrier * T(mount + shift) R(mount) Rx(rx) Ry(ry) Rz(rz)
///
/// Camera axes x forward, y left, z up; neck: the link that the last joint moves.
struct HeadCamera {
  /// The joint below the neck's last one, where it turns on the robot's root: its offset turns head and camera about a
  /// fixed axis, rootFromCamera = R(axis, -offset) * rootFromCamera at offset 0 (but for the axis' distance from the
  /// root's origin).
  struct BaseJoint {
    std::string name;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); // in the root's frame
    std::optional<double> offset;                    // reading minus true angle [rad]; absent: unknown
  };

  std::string name; // of the camera
  std::string neckJoint, neckLink;
  Eigen::Vector3d neckAxis = Eigen::Vector3d::UnitY(); // in the neck's frame
  double neckOffset = 0;                               // [rad]; part of `calibrated`
  RigidTransform drawn;                                // neckFromCamera without corrections
  std::optional<RigidTransform> calibrated; // neckFromCamera; absent: neither rotation nor neck's offset known
  std::optional<BaseJoint> base;
};

/// The head's camera of this name; with an empty name the only one that the robot carries. Throws InputError if there
/// is none, if there are several, and for a camera that no joint moves.
HeadCamera describeHeadCamera(const Robot& robot, const std::string& camera, const RobotCalibration& calibration);

/// neckFromLink of a link that is fixed to the neck. Throws InputError if there is no such link.
RigidTransform placeOnNeck(const Robot& robot, const HeadCamera& head, const std::string& link);

/// The calibration that gives a camera this direction: all of neckFromCamera is the camera's rotation, and the offset
/// of the neck's last joint is 0. `baseOffset`: of the joint below, absent: unknown [rad].
RobotCalibration calibrationFromDirection(const HeadCamera& head, const Eigen::Matrix3d& neckFromCamera,
                                          std::optional<double> baseOffset);

/// Throws InputError unless a joint turns about this axis (1e-6); `file` is the file that is made for such a robot.
void requireAxis(const Eigen::Vector3d& axis, const Eigen::Vector3d& expected, const std::string& joint,
                 const std::string& file);

} // namespace naocal

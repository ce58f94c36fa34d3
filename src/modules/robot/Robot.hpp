#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// A dimension of the robot that several links may share, such as `thigh` (one value for both sides).
struct Length {
  std::string name;
  double value = 0; // [m]
};

/// A range of angles [rad].
struct AngleRange {
  double lower = 0, upper = 0;
};

/// Limits of a joint as a piecewise linear function of another joint's angle, constant beyond the ends.
struct CoupledLimits {
  std::size_t onJoint = 0;
  std::vector<double> angles;     // of that joint, ascending [rad]
  std::vector<AngleRange> ranges; // limits of this joint at each of those angles [rad]
};

/// A joint that turns its link about `axis` (revolute; continuous where it has no limits), or shifts it along `axis`
/// (prismatic: its "angle", limits and offsets are lengths [m], its torque a force [N]).
struct Joint {
  std::string name;
  std::size_t link = 0;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); // unit vector, in the link's frame before the motion
  bool isPrismatic = false;
  AngleRange limits;                    // [rad]; infinite for a continuous joint
  std::optional<CoupledLimits> coupled; // applies in addition to `limits`
  double maxSpeed = 0;                  // [rad/s]
  double restAngle = 0;                 // with the arms hanging down; assumed where not recorded, and in plans [rad]
  std::size_t motor = 0; // index of the joint whose motor drives this one: itself, unless this joint mimics another
  // Of a joint that mimics: angle = ratio * angle of `motor` + shift.
  double ratio = 1, shift = 0;
};

/// A rigid part. parentFromLink = T(constant + sum_k lengths[k].value * direction) * rotation * R(axis, angle), or
/// * T(axis * angle) for a prismatic joint.
struct Link {
  std::string name;
  std::optional<std::size_t> parent;                  // absent: the root (torso)
  Eigen::Vector3d constant = Eigen::Vector3d::Zero(); // [m]
  struct Stretch {
    std::size_t length = 0; // index into Robot::lengths
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  };
  std::vector<Stretch> stretches;
  std::optional<Eigen::Matrix3d> rotation; // absent: parallel to the parent at angle zero, as all of a NAO
  std::optional<std::size_t> joint;        // absent: fixed to its parent
  double mass = 0;                         // [kg]
  Eigen::Vector3d centreOfMass = Eigen::Vector3d::Zero(); // in the link's frame [m]
};

/// Nominal mount of a camera: linkFromCamera = T(translation) * rotation; camera axes x forward (optical axis), y left,
/// z up. A camera that stands beside the robot has worldFromCamera instead.
struct CameraMount {
  std::string name;
  std::size_t link = 0;
  bool inWorld = false;
  Eigen::Vector3d translation = Eigen::Vector3d::Zero(); // [m]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

/// A sole. Its frame is that of its link: origin below the ankle, on the floor, x forward.
struct Sole {
  std::string name; // "left" or "right"; of a robot with a URDF the foot's link
  std::size_t link = 0;
  std::vector<Eigen::Vector2d> outline;      // convex, counter-clockwise, in the sole frame [m]
  std::vector<Eigen::Vector2d> forceSensors; // FL, FR, RL, RR in the sole frame [m]
};

/// Collision shape of a part of a link: all points within `radius` of a segment, in the link frame [m].
struct Capsule {
  std::size_t link = 0;
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  double radius = 0;
};

/// Description of a robot: a tree of links with masses, joints and cameras. Parents precede their children.
struct Robot {
  std::string model;
  std::size_t base = 0; // link that stands in the world, where no foot does
  std::vector<Length> lengths;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<CameraMount> cameras;
  std::vector<Sole> soles;
  std::vector<Capsule> collisionCapsules; // links without one are never in the way

  /// Index of the element of this name; absent if there is none.
  std::optional<std::size_t> jointIndex(std::string_view name) const;
  std::optional<std::size_t> linkIndex(std::string_view name) const;
  std::optional<std::size_t> lengthIndex(std::string_view name) const;
  std::optional<std::size_t> cameraIndex(std::string_view name) const;
  const Sole* findSole(std::string_view name) const; // nullptr if the robot has no sole of that name
};

/// Index of a link that `place` of a file names. Throws InputError if the robot has no such link.
std::size_t requireLink(const Robot& robot, const std::string& place, std::string_view link);

/// Reads a robot description. Throws InputError with file, location, expected and found.
///
/// A description with a "base" contains only the differences from that file in the same folder (a JSON merge patch, RFC
/// 7396).
Robot loadRobot(const std::filesystem::path& drawing);

/// Description of a model: `<configuration>/drawings/<model>.json` ("K1"), or Nao<model>.json ("V4", "V5", "V6").
Robot loadRobot(const std::filesystem::path& configuration, std::string_view model);

/// Configuration folder: $NAOCAL_CONFIGURATION, else ../share/naocal/configuration beside the installed program, else
/// home/configuration of the source tree.
std::filesystem::path configurationDirectory();

/// Limits of `joint` at the given angles (one per joint of the robot) [rad]: its own, intersected with the coupled
/// ones.
AngleRange jointLimitsAt(const Robot& robot, std::size_t joint, const Eigen::VectorXd& angles);

/// The normals of a joint's axis about which its bearing tilts and yields. For an axis along a coordinate axis the next
/// two coordinate axes (x -> y -> z -> x); otherwise n1 = the coordinate axis after the one along which |axis| is
/// largest, made normal to the axis, and n2 = axis x n1. For a NAO's hip yaw-pitch axis n1 = x. `axis`: unit vector.
std::array<Eigen::Vector3d, 2> bearingNormals(const Eigen::Vector3d& axis);

} // namespace naocal

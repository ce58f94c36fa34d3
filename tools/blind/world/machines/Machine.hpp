#pragma once

#include "world/Skeleton.hpp"
#include "world/machines/MachineFlaws.hpp"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace blind {

/// A robot as a URDF draws it, with the numbers of the file: joint i moves link i; the base is link -1.
struct Machine {
  struct Joint {
    std::string name, link; // link: the one that it moves
    int parent = -1;        // joint that moves the link carrying this one
    Eigen::Vector3d xyz, rpy, axis;
    bool slides = false;         // prismatic; else revolute
    double lower = 0, upper = 0; // [rad] or [m]
    double kilograms = 0;        // of its link
    Eigen::Vector3d centre;      // of that mass, in the link's frame [m]
  };
  struct Attached { // a link on a fixed joint
    std::string link;
    int joint = -1; // that moves it
    Eigen::Vector3d xyz, rpy;
  };
  struct Sole {               // of the foot that it stands on
    std::size_t joint = 0;    // that moves the foot's link
    Eigen::Vector3d xyz, rpy; // in that link's frame; z up, on the floor
  };
  std::string name;
  double baseKilograms = 0;
  Eigen::Vector3d baseCentre = Eigen::Vector3d::Zero(); // in the base's frame [m]
  std::optional<Sole> sole;                             // none: the base is fixed to the world
  std::vector<Joint> joints;                            // parents first
  std::vector<Attached> attached;                       // the last one is the hand
};

/// The text of its URDF (https://wiki.ros.org/urdf/XML).
std::string urdfText(const Machine& machine);

/// URDF's origin: a translation by xyz, then Rz(yaw) Ry(pitch) Rx(roll).
Transform originTransform(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy);
/// The inverse: roll, pitch, yaw of a rotation [rad].
Eigen::Vector3d rollPitchYaw(const Eigen::Matrix3d& turn);

/// The two directions across a joint's axis a: the coordinate axes that follow where a is one of them; otherwise
/// n1 = the one that follows where |a| is largest, made normal to a, and n2 = a x n1.
std::array<Eigen::Vector3d, 2> normalsOf(const Eigen::Vector3d& axis);

/// Link poses and gravity torques of a machine with flaws; springs and bearings are in equilibrium with gravity.
class MachineBody {
public:
  /// `worldFromSole`: of a machine that stands on a foot.
  MachineBody(const Machine& machine, const MachineFlaws& flaws, const Transform& worldFromSole = {});

  struct Posture {
    std::vector<Transform> hinges; // worldFromJoint before the joint's own turn, by joint
    std::vector<Transform> links;  // worldFromLink, by joint
    Transform base;                // worldFromBase
  };
  /// `angles`: without the deflection by springs.
  Posture settled(const Eigen::VectorXd& angles) const;
  Transform worldFromAttached(const Posture& posture, std::size_t which) const;
  /// Of gravity about each joint's axis through its origin, with the base or the foot held still [Nm], [N] where it
  /// slides.
  Eigen::VectorXd torques(const Posture& posture) const;

private:
  using Loads = std::vector<Eigen::Vector3d>; // of gravity, by joint, in its frame [Nm]
  Posture posture(const Eigen::VectorXd& angles, const Loads& loads) const;
  /// Force [N] and moment about the joint's origin [Nm] of gravity that drive it, in the world: on everything beyond
  /// it, or against everything that a joint of the standing leg carries.
  std::pair<Eigen::Vector3d, Eigen::Vector3d> loadOn(const Posture& posture, std::size_t joint) const;

  const Machine& machine_;
  const MachineFlaws& flaws_;
  Transform worldFromSole_;
  std::vector<bool> standing_;                   // by joint: between the base and the foot that it stands on
  std::vector<Transform> origins_;               // parentFromJoint with flaws, by joint
  std::vector<Eigen::Vector3d> axes_, drawn_;    // tilted, and as drawn; unit vectors
  std::vector<std::vector<std::size_t>> beyond_; // by joint: joints whose links it moves
  bool yields_ = false;                          // a spring or a bearing is not stiff
};

} // namespace blind

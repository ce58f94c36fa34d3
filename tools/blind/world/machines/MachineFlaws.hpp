#pragma once

#include "world/Flaws.hpp"

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace blind {

/// All errors of a machine and what measures it, except joint offsets and camera mounts.
struct MachineFlaws {
  struct Link {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();   // of the step to the joint [m]
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();    // Rx, Ry, Rz after it [rad]
    Eigen::Vector2d bearing = Eigen::Vector2d::Zero(); // compliance about the two normals of the axis [rad/Nm]
    double coupling = 0;                               // of the next joint towards the base [1]
  };
  std::vector<JointFlaws> joints;
  std::vector<Link> links;
  double trackerScale = 0; // [1]

  explicit MachineFlaws(std::size_t count = 0) : joints(count), links(count) {}
};

/// A kind of hidden flaw of a machine.
struct MachineFamily {
  std::string effect;
  std::vector<FlawFamily::Unknown> unknowns;
  bool positive; // its unknowns cannot be negative
  /// Adds values to a joint's flaws; families of trackers ignore the joint.
  std::function<void(MachineFlaws&, std::size_t joint, std::span<const double>)> apply;
  bool ofTracker = false;
};

/// Families of the effects catalogue that any machine has.
const std::vector<MachineFamily>& machineCatalogue();

} // namespace blind

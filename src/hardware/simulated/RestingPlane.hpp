#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace naocal {

/// The floor as seen from a rigid body at rest on it.
struct RestingPlane {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); // unit normal of the floor, in the body's frame
  double height = 0;                             // of the floor along `up`, from the body's origin [m]
  std::array<std::size_t, 3> touching{};         // indices of the contact triangle below the centre of mass
};

/// Finds how a body with these points comes to rest on a flat floor when it tilts from `up` (the previous vertical, in
/// its frame) onto the face of its lower hull below its centre of mass. Absent if it tips over: the centre of mass lies
/// outside all points, or the tilt exceeds `mostTilt` [rad].
///
/// With u = up as z axis, the floor is the plane that is highest below the centre of mass with no point below it: a
/// linear program in three unknowns, solved by exchanging one of three points at a time. The tilt changes u; iterates
/// until u converges.
std::optional<RestingPlane> findRestingPlane(const std::vector<Eigen::Vector3d>& points,
                                             const Eigen::Vector3d& centreOfMass, const Eigen::Vector3d& up,
                                             double mostTilt);

} // namespace naocal

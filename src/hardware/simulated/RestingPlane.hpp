#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace naocal {

/// The floor as a rigid body that rests on it sees it.
struct RestingPlane {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); // unit normal of the floor, in the body's frame
  double height = 0;                             // of the floor along `up` from the body's origin [m]
  std::array<std::size_t, 3> touching{};         // points whose triangle carries the centre of mass
};

/// Where a body with these points comes to rest on a flat floor, tilting from `up` (the vertical so far, in its frame)
/// onto the face of its lower hull that lies below its centre of mass. Absent when it tips over: the centre of mass is
/// beside all points, or it would tilt by more than `mostTilt` [rad] before it rests.
///
/// With u = up as z axis the floor below the points is the plane that is highest under the centre of mass while no
/// point is below it: a linear programme in three unknowns, solved by exchanging one of three points at a time. The
/// tilt turns u; this repeats until it stands.
std::optional<RestingPlane> findRestingPlane(const std::vector<Eigen::Vector3d>& points,
                                             const Eigen::Vector3d& centreOfMass, const Eigen::Vector3d& up,
                                             double mostTilt);

} // namespace naocal

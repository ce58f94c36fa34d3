#pragma once

#include "evidence/DriverColumns.hpp"
#include "residuals/Model.hpp"

#include <vector>

namespace naocal {

/// A camera's mount turning as time passes or the head moves: a rotation vector in the mount's axes, each component a
/// curve over one driver. The curves' constants are `cameraRotation`.
struct MountCurve {
  Term term;       // coefficients of the first column about x, y, z, then those of the second [rad]
  DriverCell cell; // columns of each component

  std::size_t camera() const { return term.at; }
};

/// The cameras' part of the map: every mount over time and over the angles of the joints that carry it. Two polynomials
/// suffice: a mount has no gear.
std::vector<MountCurve> mountCurves(const Measurements& measurements, const std::vector<DriverValues>& drivers);

} // namespace naocal

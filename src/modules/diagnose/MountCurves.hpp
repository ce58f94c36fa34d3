#pragma once

#include "diagnose/DriverColumns.hpp"
#include "residuals/Model.hpp"

#include <vector>

namespace naocal {

/// A camera's mount turning as time passes or the head moves: a rotation vector in the mount's axes, each component a
/// curve over one driver. The curves' constants are `cameraRotation`.
struct MountCurve {
  Term term;                   // coefficients of P_1 about x, y, z, then those of P_2 [rad]
  std::size_t driver = 0;      // into the drivers that it was made from
  Eigen::Index count = 0;      // Legendre polynomials per axis
  double middle = 0, half = 1; // the driver's range: the curve's argument is (driver - middle) / half

  std::size_t camera() const { return term.at; }
};

/// The cameras' part of the map: every mount over time and over the angles of the joints that carry it. Two polynomials
/// suffice: a mount has no gear.
std::vector<MountCurve> mountCurves(const Measurements& measurements, const std::vector<DriverValues>& drivers);

} // namespace naocal

#pragma once

#include "diagnose/Diagnosis.hpp"

namespace naocal {

/// A curve's name, as in a user's effect: a joint or camera, and what it varies with.
struct CurveName {
  std::string place, driver;
};
CurveName curveName(const Inquiry& inquiry, const Measurements& measurements, std::size_t curve);

/// A curve of an inquiry as a finding; of a mount, about the axis that turns furthest.
DriverFinding driverFinding(const Inquiry& inquiry, const Measurements& measurements, std::size_t curve);

} // namespace naocal

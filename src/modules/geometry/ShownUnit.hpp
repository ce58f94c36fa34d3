#pragma once

#include "geometry/Angles.hpp"

#include <string>
#include <utility>

namespace naocal {

/// The unit in which a person reads a quantity, and how many of it make one of its own: ("°/Nm", 57.3) for "rad/Nm".
inline std::pair<std::string, double> shownUnit(const std::string& unit) {
  if (unit.starts_with("rad")) {
    return {"°" + unit.substr(3), degrees(1.0)};
  }
  if (unit == "m") {
    return {"mm", 1000};
  }
  return {unit == "1" ? "" : unit, 1};
}

/// "3 mm", "0.2°", "0.2°/Nm", "0.2".
inline std::string withUnit(std::string number, const std::string& shownUnit) {
  const bool apart = !shownUnit.empty() && !shownUnit.starts_with("°");
  return std::move(number) + (apart ? " " : "") + shownUnit;
}

} // namespace naocal

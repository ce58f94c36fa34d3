#pragma once

#include "math/Angles.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace naocal {

/// A unit as powers of its bases: {"rad": 1, "Nm": -2} for "rad/Nm^2"; empty for "1", a plain number.
using UnitPowers = std::map<std::string, double, std::less<>>;

/// What unknowns may be counted in: a product of powers of these, as "rad/Nm^2", "s/row", "1/rad" or "1".
inline constexpr std::string_view unitBases = "rad, m, px, s, row, Nm, K or A";

/// Absent: that is no such product.
std::optional<UnitPowers> parseUnit(std::string_view text);
std::string formatUnit(const UnitPowers& unit);

/// one * other^power
UnitPowers multiplyUnits(UnitPowers one, const UnitPowers& other, double power = 1);

/// The unit in which a person reads a quantity, and how many of it make one of its own: ("°/Nm", 57.3) for "rad/Nm".
inline std::pair<std::string, double> displayUnit(const std::string& unit) {
  if (unit.starts_with("rad")) {
    return {"°" + unit.substr(3), degrees(1.0)};
  }
  if (unit == "m") {
    return {"mm", 1000};
  }
  return {unit == "1" ? "" : unit, 1};
}

/// "3 mm", "0.2°", "0.2°/Nm", "0.2".
inline std::string appendUnit(std::string number, const std::string& shownUnit) {
  const bool apart = !shownUnit.empty() && !shownUnit.starts_with("°");
  return std::move(number) + (apart ? " " : "") + shownUnit;
}

} // namespace naocal

#pragma once

#include "math/Angles.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace naocal {

/// A unit as powers of base units: {"rad": 1, "Nm": -2} for "rad/Nm^2"; empty for "1".
using UnitPowers = std::map<std::string, double, std::less<>>;

/// Base units of unknowns; a unit is a product of their powers, as "rad/Nm^2", "s/row", "1/rad" or "1".
inline constexpr std::string_view unitBases = "rad, m, px, s, row, Nm, K or A";

/// Absent if the text is not such a product.
std::optional<UnitPowers> parseUnit(std::string_view text);
/// The unit as text, such as "rad/Nm^2"; "1" without a unit.
std::string formatUnit(const UnitPowers& unit);

/// one * other^power
UnitPowers multiplyUnits(UnitPowers one, const UnitPowers& other, double power = 1);

/// Display unit of a quantity, and the factor to it: ("°/Nm", 57.3) for "rad/Nm".
inline std::pair<std::string, double> displayUnit(const std::string& unit) {
  if (unit.starts_with("rad")) {
    return {"°" + unit.substr(3), degrees(1.0)};
  }
  if (unit == "m") {
    return {"mm", 1000};
  }
  if (unit == "m/s") {
    return {"mm/s", 1000};
  }
  return {unit == "1" ? "" : unit, 1};
}

/// Decimals that show two significant digits of a standard error, at most nine; 0 where it is zero or not finite.
int decimalsFor(double sigma);
/// "0.24 mm", "0.3 mm", "134 mm", "0.044°" for a size in SI: two significant digits or all before the point, no
/// exponent.
std::string formatSize(double size, const std::string& unit);
/// "0.4755 ± 0.0086": a value and its standard error, to two significant digits of the latter.
std::string formatEstimate(double value, double sigma);

/// Appends a display unit: "3 mm", "0.2°", "0.2°/Nm", "0.2".
inline std::string appendUnit(std::string number, const std::string& shownUnit) {
  const bool apart = !shownUnit.empty() && !shownUnit.starts_with("°");
  return std::move(number) + (apart ? " " : "") + shownUnit;
}

} // namespace naocal

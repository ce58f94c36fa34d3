#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace naocal {

/// A unit as powers of its bases: {"rad": 1, "Nm": -2} for "rad/Nm^2"; empty for "1", a plain number.
using Unit = std::map<std::string, double, std::less<>>;

/// What unknowns may be counted in: a product of powers of these, as "rad/Nm^2", "s/row", "1/rad" or "1".
inline constexpr std::string_view unitBases = "rad, m, px, s, row, Nm, K or A";

/// Absent: that is no such product.
std::optional<Unit> unitOf(std::string_view text);
std::string textOf(const Unit& unit);

/// one * other^power
Unit product(Unit one, const Unit& other, double power = 1);

} // namespace naocal

#include "effects/Units.hpp"

#include <algorithm>

namespace naocal {

const std::vector<std::string_view>& units() {
  static const std::vector<std::string_view> all{"rad",      "m",     "1",     "px",    "s",     "s/row",
                                                 "Nm",       "K",     "A",     "rad/s", "rad/m", "rad/Nm",
                                                 "rad/Nm^2", "rad/K", "rad/A", "1/rad", "1/s"};
  return all;
}

bool isUnit(std::string_view unit) {
  return std::find(units().begin(), units().end(), unit) != units().end();
}

} // namespace naocal

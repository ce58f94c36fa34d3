#pragma once

#include "world/Drawing.hpp"

#include <string>

namespace blind {

inline const Drawing& naoV6() {
  static const Drawing drawing = parseRobot(std::string{NAOCAL_SOURCE_DIR} + "/home/configuration/drawings/NaoV6.json");
  return drawing;
}

} // namespace blind

#pragma once

#include "hardware/RobotState.hpp"

#include <array>

namespace naocal {

/// LoLA's order of what can be touched, which the shared block of a V5 has too.
inline constexpr std::array<bool Touch::*, 14> touchOrder{
    &Touch::chestButton,    &Touch::headFront,     &Touch::headMiddle,    &Touch::headRear,      &Touch::leftFootLeft,
    &Touch::leftFootRight,  &Touch::leftHandBack,  &Touch::leftHandLeft,  &Touch::leftHandRight, &Touch::rightFootLeft,
    &Touch::rightFootRight, &Touch::rightHandBack, &Touch::rightHandLeft, &Touch::rightHandRight};

/// A joint's status as a whole number; -1 for what cannot be one.
constexpr int statusNumber(double status) {
  return status >= 0 && status < 1e6 ? int(status) : -1;
}

} // namespace naocal

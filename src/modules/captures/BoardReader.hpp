#pragma once

#include "captures/Capture.hpp"
#include "captures/JsonPlace.hpp"

namespace naocal {

/// Where a frame lies on the floor: x, y and yaw, all given.
Placement readFloorPlacement(const JsonPlace& place);

/// An entry of a capture set's `boards`.
Board readBoard(const JsonPlace& place);

} // namespace naocal

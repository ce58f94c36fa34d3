#pragma once

#include "PlainModel.hpp"

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <cstdint>

namespace naocal {

/// The same captures in the format of the modules and of the libraries.
struct OffsetProblem {
  CaptureSet set;
  PlainProblem plain;
};

/// 8 poses x 4 boards x 20 corners seen by the top camera, on the left foot. Boards and stance are surveyed; offsets of
/// head and left leg are uniform within 6.5 degrees; corner noise 0.3 px (1 sigma). All boards lie before the camera,
/// but not always inside the image.
OffsetProblem offsetProblem(const Robot& robot, std::uint64_t seed);

/// 24 poses x 2 cameras x 3 samples of a simulated robot on its left foot, boards at unknown placements.
CaptureSet fullSet(const Robot& robot, std::uint64_t seed);

} // namespace naocal

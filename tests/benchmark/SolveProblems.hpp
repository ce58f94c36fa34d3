#pragma once

#include "PlainModel.hpp"

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <cstdint>

namespace naocal {

/// The same captures twice: for the modules and for the libraries.
struct OffsetProblem {
  CaptureSet set;
  PlainProblem plain;
};

/// 8 poses x 4 boards x 20 corners seen by the top camera from the left foot, boards and stance surveyed, offsets of
/// head and left leg within 6.5 degrees, corners within 0.3 px (1 sigma). All boards lie before the camera, though not
/// always inside the picture.
OffsetProblem offsetProblem(const Robot& robot, std::uint64_t seed);

/// 24 poses x 2 cameras x 3 samples of a simulated robot that stands on its left foot among boards of unknown
/// placement.
CaptureSet fullSet(const Robot& robot, std::uint64_t seed);

} // namespace naocal

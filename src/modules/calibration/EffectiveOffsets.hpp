#pragma once

#include "calibration/Calibration.hpp"

#include <string>
#include <vector>

namespace naocal {

/// What a joint's encoder shows too much with its gear where load and motion leave it: o with the corrections of
/// the model's other effects, the mean over the pictures in which it lies between board and camera. That much a
/// constant angle can compensate.
struct EffectiveOffset {
  std::string joint;
  double value = 0, sigma = 0; // [rad]
  double learned = 0;          // about o: 1 - posterior sigma / prior sigma
};

/// Of every measured joint.
std::vector<EffectiveOffset> effectiveOffsets(const FittedModel& fitted);

/// Whether the captures tell it: else a robot had better keep what it has.
bool isLearned(const EffectiveOffset& offset);

} // namespace naocal

#pragma once

#include "calibration/Calibration.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Mean excess of a joint's encoder reading over the modelled angle: offset o plus the corrections of the model's other
/// effects, averaged over the pictures in which the joint lies between board and camera. A constant offset can
/// compensate this much.
struct EffectiveOffset {
  std::string joint;
  double value = 0, sigma = 0; // mean and standard error [rad]
  double learned = 0;          // of o: 1 - posterior sigma / prior sigma
};

/// One entry per measured joint whose offset is in the model.
std::vector<EffectiveOffset> effectiveOffsets(const FittedModel& fitted);

/// Whether the captures determine the offset (learned >= 0.5). If not, the robot should keep its present value.
bool isLearned(const EffectiveOffset& offset);

} // namespace naocal

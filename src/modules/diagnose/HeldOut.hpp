#pragma once

#include "diagnose/Inquiry.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// How well poses are predicted that the fit has not seen: five folds of whole poses (all repeats and cameras
/// together), each predicted from the others, linearised at the fit. What only a fold's own poses tell (where the robot
/// stood then) is estimated from them.
struct HeldOut {
  double beforePx = 0;         // rms distance of corners with the model as it is
  std::vector<double> afterPx; // and with each of the candidates asked for
  double selectedPx = 0;       // with that candidate which the other folds alone would choose
};
HeldOut heldOut(const Inquiry& inquiry, const std::vector<std::size_t>& candidates);

} // namespace naocal

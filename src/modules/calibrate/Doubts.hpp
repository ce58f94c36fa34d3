#pragma once

#include "calibrate/Calibration.hpp"

namespace naocal {

/// Corners whose weight the loss took away, and sightings that lost most of their corners that way.
std::vector<Doubt> doubts(const Measurements& measurements, const CalibrationResult& result);

/// Boards in pictures that do not lie where all others put them, of all boards in pictures.
struct Accidents {
  std::size_t moved = 0, all = 0;

  Accidents(const Measurements& measurements, const std::vector<Doubt>& doubts);

  bool any() const { return moved > 0; }
  /// More than a picture or two in a set: worth a word.
  bool areMany() const { return isMore(0.05); }
  /// More than accidents move: the model is wrong, and must see them.
  bool areTooMany() const { return isMore(0.2); }
  /// How many may be set aside as accidents.
  std::size_t mostSetAside() const;

private:
  bool isMore(double share) const { return static_cast<double>(moved) > share * static_cast<double>(all); }
};

} // namespace naocal

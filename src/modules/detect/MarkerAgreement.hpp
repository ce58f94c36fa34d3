#pragma once

#include "captures/Capture.hpp"
#include "detect/Lens.hpp"
#include "detect/LocalHomography.hpp"
#include "detect/Markers.hpp"

#include <vector>

namespace naocal {

/// Markers that lie in the picture as one flat board's do, and those of the same board that do not.
struct MarkerAgreement {
  std::vector<Marker> agreeing, others;
  std::vector<SeenPoint> corners; // of the agreeing ones
};

/// The largest group of a board's markers that one homography maps onto the pattern, each corner within 3 px (or a
/// tenth of its marker's side). All `markers` must be on the board.
MarkerAgreement markerAgreement(const std::vector<Marker>& markers, const CharucoPattern& pattern, const Lens& lens);

} // namespace naocal

#pragma once

#include "detect/Detection.hpp"
#include "detect/Lens.hpp"
#include "detect/Markers.hpp"
#include "detect/SmoothPicture.hpp"

#include <vector>

namespace naocal {

/// Adds one board's corners and findings to `detection`. The corners are believed when at least six were found, half of
/// the markers that were read agree with them, and the markers beside them are printed as the pattern says.
/// `markers`: those that were read of this board; `board` has a pattern.
void detectBoard(const Board& board, const std::vector<Marker>& markers, const SmoothPicture& picture, const Lens& lens,
                 Detection& detection);

} // namespace naocal

#pragma once

#include "captures/Capture.hpp"
#include "captures/JsonPlace.hpp"

#include <vector>

namespace naocal {

/// The ChArUco keys of a board; those not given keep the defaults of CharucoPattern. Refuses what cannot be printed.
CharucoPattern readPattern(const JsonPlace& board);

/// Refuses markers that two boards share: they could not be told apart in a picture.
void requireDistinctMarkers(const std::vector<Board>& boards, const JsonPlace& place);

} // namespace naocal

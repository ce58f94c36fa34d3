#pragma once

#include "data/Capture.hpp"
#include "math/Simd.hpp"

#include <vector>

namespace naocal {

/// Corners of one board, four to a block, padded by copies of the first one that count nothing (`present` = 0).
struct CornerBlock {
  Lane x, y, z; // pointInBoard as designed [m]
  Lane bulge;   // 1 - (r / r_max)^2: how much of the board's bow is there [1]
  Lane u, v;    // measured [px]
  Lane present; // 1, or 0 for padding
};
using CornerBlocks = std::vector<CornerBlock>;

/// The corners that a capture shows of a board, ready for the inner loop.
CornerBlocks cornerBlocks(const Board& board, const BoardCorners& corners);

} // namespace naocal

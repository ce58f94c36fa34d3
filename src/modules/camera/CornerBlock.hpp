#pragma once

#include "data/Capture.hpp"
#include "math/Simd.hpp"

#include <vector>

namespace naocal {

/// Corners of one board, four to a block, padded by copies of the first one that count nothing (`present` = 0).
struct CornerBlock {
  Double4 x, y, z; // pointInBoard as designed [m]
  Double4 bulge;   // 1 - (r / r_max)^2: how much of the board's bow is there [1]
  Double4 u, v;    // measured [px]
  Double4 present; // 1, or 0 for padding
};
using CornerBlocks = std::vector<CornerBlock>;

/// The corners that a capture shows of a board, ready for the inner loop.
CornerBlocks packCorners(const Board& board, const BoardCorners& corners);

} // namespace naocal

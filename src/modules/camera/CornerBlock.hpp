#pragma once

#include "data/Capture.hpp"
#include "math/Simd.hpp"

#include <vector>

namespace naocal {

/// Corners of one board in blocks of four, padded by copies of the first one without weight (`present` = 0).
struct CornerBlock {
  Double4 x, y, z; // pointInBoard as designed [m]
  Double4 bulge;   // 1 - (r / r_max)^2: share of the board's bow at the corner [1]
  Double4 u, v;    // measured [px]
  Double4 present; // 1; below 1: a doubtful corner's weight; 0: rejected, or padding
};
using CornerBlocks = std::vector<CornerBlock>;

/// Packs a capture's corners of a board for the inner loop.
CornerBlocks packCorners(const Board& board, const BoardCorners& corners);

} // namespace naocal

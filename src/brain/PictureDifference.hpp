#pragma once

#include "io/GreyImage.hpp"

namespace naocal {

/// How far two pictures of a camera differ where they differ most [grey levels]: of blocks of 16 by 16 pixels the
/// difference of their means, less the median of the blocks beside it (lamps flicker from row to row); 19 of 20 blocks
/// differ by less. Noise of single pixels averages out. Infinite for pictures of different sizes.
double pictureDifference(const GreyPicture& one, const GreyPicture& other);

} // namespace naocal

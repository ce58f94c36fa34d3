#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace naocal {

/// A grey picture, row by row from the top left. Pixel (0,0) is the centre of the top-left pixel.
struct GreyPicture {
  int width = 0, height = 0;        // [px]
  std::vector<std::uint8_t> pixels; // [grey level]; width * height of them

  std::uint8_t at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

} // namespace naocal

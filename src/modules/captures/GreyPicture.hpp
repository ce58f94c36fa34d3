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

/// The grey level of red, green and blue: Y, as JPEG and cameras define it (ITU-R BT.601-7, 2.5.1).
inline std::uint8_t luma(const std::uint8_t* rgb) {
  return static_cast<std::uint8_t>((299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2] + 500) / 1000);
}

} // namespace naocal

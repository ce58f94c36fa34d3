#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// A grey picture, row by row from the top left. Pixel (0,0) is the centre of the top-left pixel.
struct GreyPicture {
  int width = 0, height = 0;        // [px]
  std::vector<std::uint8_t> pixels; // [grey level]; width * height of them

  std::uint8_t grey(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

/// The grey level of red, green and blue: Y, as JPEG and cameras define it (ITU-R BT.601-7, 2.5.1).
inline std::uint8_t luma(const std::uint8_t* rgb) {
  return static_cast<std::uint8_t>((299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2] + 500) / 1000);
}

/// A picture file's grey levels; colours become their luma, what is transparent white. Throws
/// InputError, with what the picture is called, where it is neither PNG nor JPEG, is cut off or has more than 64
/// million pixels.
GreyPicture decodeImage(std::string_view content, const std::string& name);
GreyPicture readImage(const std::filesystem::path& file);

/// As a PNG: every grey level is kept.
std::string encodePng(const GreyPicture& picture);

/// As a JPEG. `pixels`: row by row, width * height of them, one byte each or three (red, green, blue); `quality` 1 to
/// 100.
std::string encodeJpeg(std::span<const std::uint8_t> pixels, int width, int height, int quality);

/// Writes a PNG or JPEG, as the file's name ends (.png, .jpg), at once or not at all. Throws InputError.
void writeImage(const GreyPicture& picture, const std::filesystem::path& file);

} // namespace naocal

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
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

/// Luma Y of red, green and blue, as in JPEG and cameras (ITU-R BT.601-7, 2.5.1).
inline std::uint8_t luma(const std::uint8_t* rgb) {
  return static_cast<std::uint8_t>((299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2] + 500) / 1000);
}

/// Width and height of a picture.
struct PictureSize {
  int width, height; // [px]
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// The size that a PNG's or JPEG's header announces; nothing is decoded. Throws InputError naming the picture if there
/// is no such header, or for more than 64 million pixels.
PictureSize imageSize(std::string_view content, const std::string& name);

/// Decodes the grey levels of a PNG or JPEG; converts colours to luma and transparent pixels to white. Throws
/// InputError naming the picture if the format is unknown, the content is truncated, it exceeds 64 million pixels, or
/// its header announces another size than its camera's (`described`); that is checked before anything is decoded.
GreyPicture decodeImage(std::string_view content, const std::string& name,
                        const std::optional<PictureSize>& described = std::nullopt);
/// The same of a file. Throws InputError also if it cannot be read.
GreyPicture readImage(const std::filesystem::path& file, const std::optional<PictureSize>& described = std::nullopt);

/// Encodes as PNG (lossless).
std::string encodePng(const GreyPicture& picture);

/// Encodes as JPEG. `pixels`: width * height, row by row, one byte each or three (red, green, blue); `quality`: 1 to
/// 100.
std::string encodeJpeg(std::span<const std::uint8_t> pixels, int width, int height, int quality);

/// Writes a PNG or JPEG atomically, according to the extension (.png, .jpg). Throws InputError.
void writeImage(const GreyPicture& picture, const std::filesystem::path& file);

} // namespace naocal

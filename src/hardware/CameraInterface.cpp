#include "hardware/CameraInterface.hpp"

namespace naocal {
namespace {

std::size_t bytesPerPixel(PixelFormat format) {
  return format == PixelFormat::grey ? 1 : format == PixelFormat::yuyv ? 2 : 3;
}

} // namespace

std::span<const std::uint8_t> completeBytes(const CameraFrame& frame) {
  const std::span<const std::uint8_t> bytes = frame.picture ? frame.picture->bytes() : std::span<const std::uint8_t>{};
  const std::size_t count = std::size_t(frame.width) * std::size_t(frame.height);
  const bool whole = frame.width > 0 && frame.height > 0 && bytes.size() == bytesPerPixel(frame.format) * count;
  return whole ? bytes : std::span<const std::uint8_t>{};
}

std::optional<GreyPicture> toGreyImage(const CameraFrame& frame) {
  const std::span<const std::uint8_t> bytes = completeBytes(frame);
  if (bytes.empty()) {
    return std::nullopt;
  }
  const std::size_t count = std::size_t(frame.width) * std::size_t(frame.height);
  const std::size_t perPixel = bytesPerPixel(frame.format);
  GreyPicture grey{frame.width, frame.height, std::vector<std::uint8_t>(count)};
  for (std::size_t pixel = 0; pixel < count; ++pixel) {
    const std::uint8_t* at = &bytes[perPixel * pixel];
    grey.pixels[pixel] = perPixel < 3 ? *at : luma(at);
  }
  return grey;
}

} // namespace naocal

#include "hardware/CameraInterface.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

struct Bytes : ImageBytes {
  explicit Bytes(std::vector<std::uint8_t> all) : all{std::move(all)} {}
  std::span<const std::uint8_t> bytes() const override { return all; }
  std::vector<std::uint8_t> all;
};

CameraFrame frame(PixelFormat format, int width, int height, std::vector<std::uint8_t> bytes) {
  return {CameraName::top, format, width, height, {}, 0, std::make_shared<Bytes>(std::move(bytes))};
}

} // namespace

// Proves which bytes of each format give the brightness. Colours are not covered.
TEST_CASE("a frame's brightness is every second byte of YUYV, every byte of grey, and BT.601's sum of RGB") {
  CHECK(toGreyImage(frame(PixelFormat::yuyv, 2, 2, {1, 99, 2, 98, 3, 97, 4, 96}))->pixels ==
        std::vector<std::uint8_t>{1, 2, 3, 4});
  CHECK(toGreyImage(frame(PixelFormat::grey, 3, 1, {7, 8, 9}))->pixels == std::vector<std::uint8_t>{7, 8, 9});
  CHECK(toGreyImage(frame(PixelFormat::rgb, 4, 1, {255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255}))->pixels ==
        std::vector<std::uint8_t>{255, 76, 150, 29});
}

// Proves that inconsistent sizes give no image, so no byte outside the frame is read.
TEST_CASE("a frame whose bytes are not as many as its format and size say has no brightness") {
  CHECK(!toGreyImage(frame(PixelFormat::yuyv, 2, 2, {1, 2, 3, 4})));
  CHECK(!toGreyImage(frame(PixelFormat::grey, 0, 0, {})));
  CHECK(!toGreyImage(frame(PixelFormat::grey, -2, -2, {1, 2, 3, 4})));
  CHECK(!toGreyImage(CameraFrame{}));
}

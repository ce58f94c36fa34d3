#include "brain/PictureDifference.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace naocal {
namespace {

/// A chessboard of 40-pixel squares from `shift` on, with noise of 3 grey levels; rows 100 to 200 lit by `flicker`
/// more.
GreyPicture picture(double shift, unsigned seed, int flicker = 0) {
  std::mt19937 random{seed};
  std::normal_distribution<double> noise{0, 3};
  GreyPicture result{640, 480, {}};
  for (int v = 0; v < result.height; ++v) {
    for (int u = 0; u < result.width; ++u) {
      const double wave = std::sin((u + shift) * 0.0785) * std::sin(v * 0.0785);
      const double grey = 128 + (wave > 0 ? 80 : -80) * std::min(1.0, 8 * std::abs(wave));
      const double light = v >= 100 && v < 200 ? flicker : 0;
      result.pixels.push_back(static_cast<std::uint8_t>(std::clamp(grey + light + noise(random), 0.0, 255.0)));
    }
  }
  return result;
}

} // namespace

TEST_CASE("pictures differ when half a pixel has moved, not by noise or flicker") {
  // Proves it for the limit that CalibrationRunner.json ships, 2 grey levels.
  CHECK(pictureDifference(picture(0, 1), picture(0, 2)) < 1);
  CHECK(pictureDifference(picture(0, 1), picture(0, 2, 10)) < 1.5);
  CHECK(pictureDifference(picture(0, 1), picture(0.5, 2)) > 2);
  CHECK(std::isinf(pictureDifference(picture(0, 1), GreyPicture{320, 240, std::vector<std::uint8_t>(320 * 240)})));
}

} // namespace naocal

#pragma once

#include "hardware/RobotState.hpp"
#include "io/GreyImage.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace naocal {

enum class CameraName { top, bottom };

/// "top" or "bottom", as in capture sets and configuration.
constexpr std::string_view toString(CameraName camera) {
  return camera == CameraName::top ? "top" : "bottom";
}

enum class PixelFormat {
  yuyv, // Y0 Cb Y1 Cr: two bytes per pixel
  grey, // one byte
  rgb,  // R G B: three bytes
};

/// The bytes of a picture, row by row from the top left without padding. Immutable; any thread may read.
class PictureBytes {
public:
  virtual ~PictureBytes() = default;

  /// Valid as long as this object. A simulated camera renders in the first call (tens of ms), a replay reads its file;
  /// whoever does not look at a picture does not pay for it. Empty when the picture could not be had (a lost file).
  virtual std::span<const std::uint8_t> bytes() const = 0;
};

/// One picture of one camera. Copies share the bytes.
struct CameraFrame {
  CameraName camera = CameraName::top;
  PixelFormat format = PixelFormat::yuyv;
  int width = 0, height = 0; // [px]
  /// The driver's stamp: when the first row began to be exposed. The middle of the exposure lies half the exposure time
  /// and half the read-out later, about 17 ms, which is a parameter of whoever pairs pictures with joints.
  TimePoint time;
  std::uint64_t sequence =
      0; // of this camera, counts pictures taken: gaps are pictures lost. Goes on after a reopening
  std::shared_ptr<const PictureBytes> picture;
};

/// Its bytes; none when they are not as many as format and size say.
std::span<const std::uint8_t> wholePicture(const CameraFrame& frame);

/// Its brightness; absent when the bytes are not as many as format and size say.
std::optional<GreyPicture> greyPicture(const CameraFrame& frame);

} // namespace naocal

#pragma once

#include "hardware/RobotInterface.hpp"
#include "io/GreyImage.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
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
class ImageBytes {
public:
  virtual ~ImageBytes() = default;

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
  std::shared_ptr<const ImageBytes> picture;
};

/// Its bytes; none when they are not as many as format and size say.
std::span<const std::uint8_t> completeBytes(const CameraFrame& frame);

/// Its brightness; absent when the bytes are not as many as format and size say.
std::optional<GreyPicture> toGreyImage(const CameraFrame& frame);

/// How a camera fares.
struct CameraStatus {
  std::uint64_t frames = 0;  // given to the program
  std::uint64_t skipped = 0; // taken, but a newer one was there when the program asked
  std::uint64_t lost = 0;    // that the driver took and never delivered: gaps of its sequence numbers
  std::uint64_t undated = 0; // whose driver's time means nothing here: they count from when they came
  std::uint64_t broken = 0;  // delivered but marked as damaged by the driver; not given to the program
  std::uint64_t reopened = 0;
  std::string problem; // one sentence while the camera gives nothing, or when it refused a setting; else empty
};

/// The cameras of a robot: real, replayed or simulated.
///
/// Threads: made and destroyed by whoever starts the camera loop's thread, while that does not run; all other calls
/// come from that thread alone. It never waits for the motion thread, nor that for it. Nothing throws after
/// construction: a camera that is gone is absence and a sentence in `status()`, and it is opened again by the next
/// calls while the other one goes on.
class CameraInterface {
public:
  virtual ~CameraInterface() = default;

  /// Blocks until one of the cameras has a picture that was not given yet; of several pictures of one camera the
  /// newest, of both cameras the older. Absent after `timeout` (wall time), or at the end of a replay.
  virtual std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) = 0;

  /// Nothing will come any more: a replay is over.
  virtual bool hasEnded() const { return false; }

  /// A camera's settings by the names of v4l2/VideoOptions.hpp, such as exposure; cameras that have none ignore them.
  /// What a camera refuses stands in `status`.
  virtual void configure(CameraName, const std::map<std::string, int>& /*settings*/) {}

  virtual CameraStatus status(CameraName camera) const = 0;
};

} // namespace naocal

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

/// Bytes of an image, row by row from the top left without padding. Immutable; thread-safe to read.
class ImageBytes {
public:
  virtual ~ImageBytes() = default;

  /// Valid as long as this object. Lazy: a simulated camera renders (tens of ms) and a replay reads its file in the
  /// first call. Empty if the image is unavailable (missing file).
  virtual std::span<const std::uint8_t> bytes() const = 0;
};

/// One image of one camera. Copies share the bytes.
struct CameraFrame {
  CameraName camera = CameraName::top;
  PixelFormat format = PixelFormat::yuyv;
  int width = 0, height = 0; // [px]
  /// The driver's stamp: start of exposure of the first row. Mid-exposure follows half the exposure time plus half the
  /// read-out time later, about 17 ms; the module that pairs images with joints has it as a parameter.
  TimePoint time;
  std::uint64_t sequence = 0; // per camera, counts exposed images: gaps are lost images; continues after reopening
  std::shared_ptr<const ImageBytes> picture;
};

/// The bytes; empty if their number does not match format and size.
std::span<const std::uint8_t> completeBytes(const CameraFrame& frame);

/// The brightness; absent if the number of bytes does not match format and size.
std::optional<GreyPicture> toGreyImage(const CameraFrame& frame);

/// Counters and problem of a camera.
struct CameraStatus {
  std::uint64_t frames = 0;  // delivered to the program
  std::uint64_t skipped = 0; // replaced by a newer image before the program took them
  std::uint64_t lost = 0;    // exposed but never delivered by the driver: gaps in its sequence numbers
  std::uint64_t undated = 0; // without a valid driver time stamp; the arrival time is used
  std::uint64_t broken = 0;  // marked as damaged by the driver; not delivered
  std::uint64_t reopened = 0;
  std::string problem; // one sentence if the camera delivers nothing or refused a setting; otherwise empty
};

/// The cameras of a robot: real, replayed or simulated.
///
/// Threading: constructed and destroyed by the thread that starts the camera loop, while that loop does not run; all
/// other calls come from the camera loop only. It never waits for the motion thread, nor vice versa. Nothing throws
/// after construction: a lost camera yields no images and a sentence in `status()`; the next calls reopen it while the
/// other camera continues.
class CameraInterface {
public:
  virtual ~CameraInterface() = default;

  /// Blocks until a camera has a new image: the newest image of each camera, the older one of the two cameras. Absent
  /// after `timeout` (wall time), or at the end of a replay.
  virtual std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) = 0;

  /// No more images will arrive: a replay has ended.
  virtual bool hasEnded() const { return false; }

  /// Changes a camera's settings, named as in v4l2/VideoOptions.hpp, such as exposure; ignored by cameras without
  /// settings. `status` reports refused settings.
  virtual void configure(CameraName, const std::map<std::string, int>& /*settings*/) {}

  virtual CameraStatus status(CameraName camera) const = 0;
};

} // namespace naocal

#pragma once

#include "hardware/CameraInterface.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A setting of a camera, by V4L2's number (V4L2_CID_...). Set in the order given, because automatics forbid what they
/// do themselves.
struct VideoControl {
  std::string name; // for people
  std::uint32_t id = 0;
  std::int32_t value = 0;
};

/// V4L2's number of a control by its name in the configuration: autoExposure, exposure, autoWhiteBalance,
/// whiteBalanceTemperature, brightness, contrast, gain, hue, saturation, sharpness, autoFocus, focus, and what V5 calls
/// exposure, plainExposure. Absent for other names.
std::optional<std::uint32_t> videoControlId(std::string_view name);

/// A UVC extension unit's setting of two bytes: how a V6's cameras are flipped.
struct VideoExtension {
  std::string name; // for people
  std::uint8_t unit = 0, selector = 0;
  std::uint16_t value = 0;
};

/// One camera and how it shall be.
struct VideoOptions {
  std::string path;
  CameraName camera = CameraName::top;
  int width = 640, height = 480; // YUYV
  int framesPerSecond = 30;
  int input = 0;
  unsigned buffers = 4;
  std::vector<VideoControl> controls;
  std::vector<VideoExtension> extensions;
};

/// The cameras of a model ("V5" or "V6"), the upper one upside down: device files, flips, focus. Throws
/// std::invalid_argument for other models. Source: HULKs code release 2019, Hardware/Nao.
std::vector<VideoOptions> videoOptionsForModel(std::string_view model);

} // namespace naocal

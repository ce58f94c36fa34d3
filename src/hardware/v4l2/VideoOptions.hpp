#pragma once

#include "hardware/CameraInterface.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A camera setting by its V4L2 number (V4L2_CID_...). The order matters: automatic modes block the manual values they
/// control.
struct VideoControl {
  std::string name; // for display
  std::uint32_t id = 0;
  std::int32_t value = 0;
};

/// The V4L2 number of a control by its configuration name: autoExposure, exposure, autoWhiteBalance,
/// whiteBalanceTemperature, brightness, contrast, gain, hue, saturation, sharpness, autoFocus, focus, and plainExposure
/// (exposure on a V5). Absent for other names.
std::optional<std::uint32_t> videoControlId(std::string_view name);

/// A two-byte setting of a UVC extension unit; flips a V6's cameras.
struct VideoExtension {
  std::string name; // for display
  std::uint8_t unit = 0, selector = 0;
  std::uint16_t value = 0;
};

/// Device, format and settings of one camera.
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

/// Options of a model's cameras ("V5" or "V6"; the top camera is mounted upside down): device files, flips, focus.
/// Throws std::invalid_argument for other models. Source: HULKs code release 2019, Hardware/Nao.
std::vector<VideoOptions> videoOptionsForModel(std::string_view model);

} // namespace naocal

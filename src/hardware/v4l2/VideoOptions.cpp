#include "hardware/v4l2/VideoOptions.hpp"

#include <array>
#include <fmt/format.h>
#include <linux/v4l2-controls.h>
#include <stdexcept>
#include <utility>

namespace naocal {

std::optional<std::uint32_t> videoControlId(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::uint32_t>, 13> controls{{
      {"autoExposure", V4L2_CID_EXPOSURE_AUTO},
      {"exposure", V4L2_CID_EXPOSURE_ABSOLUTE},
      {"plainExposure", V4L2_CID_EXPOSURE},
      {"autoWhiteBalance", V4L2_CID_AUTO_WHITE_BALANCE},
      {"whiteBalanceTemperature", V4L2_CID_WHITE_BALANCE_TEMPERATURE},
      {"brightness", V4L2_CID_BRIGHTNESS},
      {"contrast", V4L2_CID_CONTRAST},
      {"gain", V4L2_CID_GAIN},
      {"hue", V4L2_CID_HUE},
      {"saturation", V4L2_CID_SATURATION},
      {"sharpness", V4L2_CID_SHARPNESS},
      {"autoFocus", V4L2_CID_FOCUS_AUTO},
      {"focus", V4L2_CID_FOCUS_ABSOLUTE},
  }};
  for (const auto& [known, id] : controls) {
    if (known == name) {
      return id;
    }
  }
  return std::nullopt;
}

std::vector<VideoOptions> videoOptionsForModel(std::string_view model) {
  std::vector<VideoOptions> cameras(2);
  cameras[1].camera = CameraName::bottom;
  for (VideoOptions& camera : cameras) {
    const bool top = camera.camera == CameraName::top;
    if (model == "V5") {
      camera.path = top ? "/dev/video0" : "/dev/video1";
      camera.controls = {{"horizontal flip", V4L2_CID_HFLIP, top}, {"vertical flip", V4L2_CID_VFLIP, top}};
    } else if (model == "V6") {
      camera.path = top ? "/dev/video-top" : "/dev/video-bottom";
      camera.extensions = {{"horizontal flip", 3, 0x0c, top}, {"vertical flip", 3, 0x0d, top}};
      camera.controls = {{"automatic focus", V4L2_CID_FOCUS_AUTO, 0}, {"focus", V4L2_CID_FOCUS_ABSOLUTE, top ? 0 : 25}};
    } else {
      throw std::invalid_argument{fmt::format("the cameras of a NAO {} are not known, those of V5 and V6 are", model)};
    }
  }
  return cameras;
}

} // namespace naocal

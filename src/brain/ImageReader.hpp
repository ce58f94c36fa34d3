#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/CameraInterface.hpp"

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// The last image; `isNew` in the cycle in which it arrived.
struct NewFrame {
  bool isNew = false;
  CameraFrame frame;
};
void to_json(nlohmann::json& out, const NewFrame& frame);
void to_json(nlohmann::json& out, const CameraStatus& link);

/// A camera image for display: JPEG of quality 75, in colour if the frame has colour.
struct DisplayFrame {
  CameraFrame frame;
};
EncodedImage toImage(const DisplayFrame& shown);

/// Waits for the cameras' next image and thereby paces the brain thread. Continues without an image after 200 ms, so
/// that the thread can end and report problems.
///
/// The cycle time is the image's time stamp, at least 1 ms after the previous one: clients that pair images and values
/// by time stamp [ms] never see two equal ones.
class ImageReader final : public Module {
public:
  explicit ImageReader(CameraInterface& cameras) : Module{"ImageReader"}, cameras_{cameras} {}
  void cycle() override;
  void onParametersChanged() override;

private:
  using Settings = std::map<std::string, int>;
  static std::string known(const Settings& settings);

  CameraInterface& cameras_;
  TimePoint last_;
  std::array<Settings, 2> set_; // by CameraName
  Parameter<Settings> topSettings_{*this, "topSettings", known}, bottomSettings_{*this, "bottomSettings", known};
  Production<NewFrame> frame_{*this, "frame"};
  Production<DisplayFrame> top_{*this, "CameraCalibration.top_image"}; // keys used by HULKs' panel
  Production<DisplayFrame> bottom_{*this, "CameraCalibration.bottom_image"};
  Production<std::map<std::string, CameraStatus>> links_{*this, "cameraLinks"};
};

} // namespace naocal

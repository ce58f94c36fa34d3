#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/CameraInterface.hpp"

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// The picture that came last; `isNew` in the cycle in which it came.
struct NewFrame {
  bool isNew = false;
  CameraFrame frame;
};
void to_json(nlohmann::json& out, const NewFrame& frame);
void to_json(nlohmann::json& out, const CameraStatus& link);

/// A camera's picture for people: as a JPEG of quality 75, in colour where it has any.
struct DisplayFrame {
  CameraFrame frame;
};
EncodedImage toImage(const DisplayFrame& shown);

/// Waits for the cameras' next picture: the brain thread's pace. Goes on without one after a fifth of a second, so that
/// the thread can end and say what is wrong.
///
/// A cycle's time is its picture's, in whole milliseconds later than the cycle before: whoever pairs pictures and
/// values by their timestamps [ms] never sees two of one time.
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
  Production<DisplayFrame> top_{*this, "CameraCalibration.top_image"}; // the keys that HULKs' panel asks for
  Production<DisplayFrame> bottom_{*this, "CameraCalibration.bottom_image"};
  Production<std::map<std::string, CameraStatus>> links_{*this, "cameraLinks"};
};

} // namespace naocal

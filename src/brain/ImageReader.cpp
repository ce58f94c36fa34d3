#include "brain/ImageReader.hpp"

#include "hardware/nao/VideoOptions.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

std::string ImageReader::known(const Settings& settings) {
  const bool all =
      std::all_of(settings.begin(), settings.end(), [](const auto& one) { return videoControl(one.first); });
  return all ? "" : "settings of a camera, such as {\"autoExposure\": 1, \"exposure\": 100}";
}

void ImageReader::parametersChanged() {
  for (const CameraName camera : {CameraName::top, CameraName::bottom}) {
    const Settings& wanted = camera == CameraName::top ? *topSettings_ : *bottomSettings_;
    if (Settings& set = set_[std::size_t(camera)]; set != wanted) {
      cameras_.configure(camera, wanted);
      set = wanted;
    }
  }
}

void ImageReader::cycle() {
  auto frame = cameras_.waitForFrame(std::chrono::milliseconds{200});
  frame_.edit().isNew = frame.has_value();
  links_ = {{"top", cameras_.link(CameraName::top)}, {"bottom", cameras_.link(CameraName::bottom)}};
  if (!frame) {
    return;
  }
  last_ = std::max(frame->time, last_ + std::chrono::milliseconds{1});
  setCycleTime(last_);
  (frame->camera == CameraName::top ? top_ : bottom_) = ShownFrame{*frame};
  frame_.edit().frame = *std::move(frame);
}

} // namespace naocal

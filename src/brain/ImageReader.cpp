#include "brain/ImageReader.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

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

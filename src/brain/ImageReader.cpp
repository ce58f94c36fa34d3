#include "brain/ImageReader.hpp"

#include "hardware/v4l2/VideoOptions.hpp"
#include "io/GreyImage.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

namespace naocal {

std::string ImageReader::known(const Settings& settings) {
  const bool all =
      std::all_of(settings.begin(), settings.end(), [](const auto& one) { return videoControlId(one.first); });
  return all ? "" : "settings of a camera, such as {\"autoExposure\": 1, \"exposure\": 100}";
}

void ImageReader::onParametersChanged() {
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
  links_ = {{"top", cameras_.status(CameraName::top)}, {"bottom", cameras_.status(CameraName::bottom)}};
  if (!frame) {
    return;
  }
  last_ = std::max(frame->time, last_ + std::chrono::milliseconds{1});
  setCycleTime(last_);
  (frame->camera == CameraName::top ? top_ : bottom_) = DisplayFrame{*frame};
  frame_.edit().frame = *std::move(frame);
}

EncodedImage toImage(const DisplayFrame& shown) {
  const CameraFrame& frame = shown.frame;
  std::span<const std::uint8_t> pixels = completeBytes(frame);
  if (pixels.empty()) {
    return {};
  }
  cv::Mat colours;
  if (frame.format == PixelFormat::yuyv) {
    // OpenCV does not write through this pointer
    const cv::Mat picture{frame.height, frame.width, CV_8UC2, const_cast<std::uint8_t*>(pixels.data())};
    cv::cvtColor(picture, colours, cv::COLOR_YUV2RGB_YUYV);
    pixels = {colours.data, 3 * colours.total()};
  }
  return {static_cast<std::uint16_t>(frame.width), static_cast<std::uint16_t>(frame.height),
          encodeJpeg(pixels, frame.width, frame.height, 75)};
}

void to_json(nlohmann::json& out, const NewFrame& frame) {
  out = {{"isNew", frame.isNew},
         {"camera", toString(frame.frame.camera)},
         {"sequence", frame.frame.sequence},
         {"width", frame.frame.width},
         {"height", frame.frame.height}};
}

void to_json(nlohmann::json& out, const CameraStatus& link) {
  out = {{"frames", link.frames}, {"skipped", link.skipped},   {"lost", link.lost},      {"undated", link.undated},
         {"broken", link.broken}, {"reopened", link.reopened}, {"problem", link.problem}};
}

} // namespace naocal

#include "brain/NewFrame.hpp"

#include "io/GreyImage.hpp"

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

namespace naocal {

EncodedPicture toPicture(const ShownFrame& shown) {
  const CameraFrame& frame = shown.frame;
  std::span<const std::uint8_t> pixels = wholePicture(frame);
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
          jpeg(pixels, frame.width, frame.height, 75)};
}

void to_json(nlohmann::json& out, const NewFrame& frame) {
  out = {{"isNew", frame.isNew},
         {"camera", toString(frame.frame.camera)},
         {"sequence", frame.frame.sequence},
         {"width", frame.frame.width},
         {"height", frame.frame.height}};
}

void to_json(nlohmann::json& out, const CameraLink& link) {
  out = {{"frames", link.frames}, {"skipped", link.skipped},   {"lost", link.lost},      {"undated", link.undated},
         {"broken", link.broken}, {"reopened", link.reopened}, {"problem", link.problem}};
}

} // namespace naocal

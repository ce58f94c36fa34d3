#include "brain/NewFrame.hpp"

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace naocal {
namespace {

/// The picture as OpenCV writes it; empty when it has not as many bytes as format and size say.
cv::Mat writable(const CameraFrame& frame) {
  const auto bytes = frame.picture ? frame.picture->bytes() : std::span<const std::uint8_t>{};
  const int channels = frame.format == PixelFormat::grey ? 1 : frame.format == PixelFormat::yuyv ? 2 : 3;
  if (frame.width <= 0 || frame.height <= 0 ||
      bytes.size() != std::size_t(frame.width) * std::size_t(frame.height) * std::size_t(channels)) {
    return {};
  }
  // OpenCV does not write through this pointer
  const cv::Mat picture{frame.height, frame.width, CV_8UC(channels), const_cast<std::uint8_t*>(bytes.data())};
  cv::Mat colours;
  if (channels == 1) {
    return picture;
  }
  cv::cvtColor(picture, colours, channels == 2 ? cv::COLOR_YUV2BGR_YUYV : cv::COLOR_RGB2BGR);
  return colours;
}

} // namespace

EncodedPicture toPicture(const ShownFrame& shown) {
  const cv::Mat picture = writable(shown.frame);
  if (picture.empty()) {
    return {};
  }
  std::vector<std::uint8_t> file;
  cv::imencode(".jpg", picture, file, {cv::IMWRITE_JPEG_QUALITY, 75});
  return {static_cast<std::uint16_t>(picture.cols), static_cast<std::uint16_t>(picture.rows),
          std::string{file.begin(), file.end()}};
}

void to_json(nlohmann::json& out, const NewFrame& frame) {
  out = {{"isNew", frame.isNew},
         {"camera", toString(frame.frame.camera)},
         {"sequence", frame.frame.sequence},
         {"width", frame.frame.width},
         {"height", frame.frame.height}};
}

void to_json(nlohmann::json& out, const CameraLink& link) {
  out = {{"frames", link.frames}, {"skipped", link.skipped},   {"lost", link.lost},
         {"broken", link.broken}, {"reopened", link.reopened}, {"problem", link.problem}};
}

} // namespace naocal

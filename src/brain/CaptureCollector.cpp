#include "brain/CaptureCollector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

namespace naocal {
namespace {

constexpr std::size_t mostWaiting = 8; // images; oldest are dropped if the motion thread reports nothing for longer

std::vector<double> listOf(const PerJoint<double>& values) {
  return {values.begin(), values.end()};
}

/// The capture of an image and the raw measurements at mid-exposure; without pose and corners.
Capture makeCapture(const CameraFrame& frame, TimePoint middle, const JointSample& moment) {
  Capture capture;
  capture.time = middle.time_since_epoch();
  capture.camera = toString(frame.camera);
  capture.joints = {.measured = listOf(moment.raw.values),
                    .commanded = listOf(moment.sent.values),
                    .velocity = listOf(moment.speeds),
                    .temperature = listOf(moment.temperatures),
                    .current = listOf(moment.currents)};
  capture.imu = Eigen::Vector2d{moment.tilt[0], moment.tilt[1]};
  capture.fsr = moment.forces;
  return capture;
}

} // namespace

void CaptureCollector::cycle() {
  StillImage& picture = picture_.edit();
  picture.isNew = picture.isMoving = false;
  if (frame_->isNew) {
    waiting_.push_back(frame_->frame);
    if (waiting_.size() > mostWaiting) {
      waiting_.pop_front();
    }
  }
  const auto newest = moments_->newest();
  if (waiting_.empty() || !newest) {
    return;
  }
  const TimePoint middle = waiting_.front().time + fromSeconds(*latency_);
  if (middle > newest->time) {
    return; // not measured yet
  }
  if (const auto moment = moments_->at(middle); moment && moment->stillFor > 0) {
    picture = {true, false, waiting_.front(), makeCapture(waiting_.front(), middle, *moment), moment->stillFor};
  } else if (moment) {
    picture.isMoving = true;
  }
  waiting_.pop_front();
}

void to_json(nlohmann::json& out, const StillImage& picture) {
  out = {{"isNew", picture.isNew},
         {"camera", picture.capture.camera},
         {"time", picture.capture.time.count()},
         {"stillFor", picture.stillFor}};
}

double imageDifference(const GreyPicture& one, const GreyPicture& other) {
  constexpr int block = 16;
  constexpr double share = 0.95;
  if (one.width != other.width || one.height != other.height || one.width < block || one.height < block) {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<double> all;
  for (int top = 0; top + block <= one.height; top += block) {
    std::vector<double> row;
    for (int left = 0; left + block <= one.width; left += block) {
      int sum = 0;
      for (int v = top; v < top + block; ++v) {
        const std::size_t first = std::size_t(v) * std::size_t(one.width) + std::size_t(left);
        for (std::size_t i = first; i < first + block; ++i) {
          sum += one.pixels[i] - other.pixels[i];
        }
      }
      row.push_back(double(sum) / (block * block));
    }
    std::vector<double> sorted = row;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    for (const double difference : row) {
      all.push_back(std::abs(difference - *middle));
    }
  }
  const auto most = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), most, all.end());
  return *most;
}

} // namespace naocal

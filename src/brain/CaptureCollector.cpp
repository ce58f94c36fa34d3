#include "brain/CaptureCollector.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr std::size_t mostWaiting = 8; // pictures: a motion thread that is silent for longer has lost the robot

std::vector<double> listOf(const PerJoint<double>& values) {
  return {values.begin(), values.end()};
}

} // namespace

Capture captureOf(const CameraFrame& frame, TimePoint middle, const JointMoment& moment) {
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

void CaptureCollector::cycle() {
  StillPicture& picture = picture_.edit();
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
    picture = {true, false, waiting_.front(), captureOf(waiting_.front(), middle, *moment), moment->stillFor};
  } else if (moment) {
    picture.isMoving = true;
  }
  waiting_.pop_front();
}

void to_json(nlohmann::json& out, const StillPicture& picture) {
  out = {{"isNew", picture.isNew},
         {"camera", picture.capture.camera},
         {"time", picture.capture.time.count()},
         {"stillFor", picture.stillFor}};
}

} // namespace naocal

#include "brain/ReplayedCalibration.hpp"

#include "hardware/Joints.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// The robot's readings in the order of the recording's joints; what it did not record stays unrecorded.
std::vector<double> inRecordedOrder(const std::vector<double>& readings, const std::vector<double>& recorded,
                                    const std::vector<std::string>& joints) {
  std::vector<double> result = recorded;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto joint = jointIndex(joints[i]);
    if (joint && *joint < readings.size() && !std::isnan(result[i])) {
      result[i] = readings[*joint];
    }
  }
  return result;
}

} // namespace

ReplayedCalibration::ReplayedCalibration(const Robot& drawing, const ReplayWorld& world, std::filesystem::path folder,
                                         ModelFile model)
    : Module{"ReplayedCalibration"}, world_{world} {
  CaptureSet header = world.set();
  header.captures.clear();
  header.source = nullptr;
  session_.emplace(drawing, std::move(header), std::move(folder), std::move(model));
}

void ReplayedCalibration::cycle() {
  const Capture* recorded = picture_->isNew ? world_.captureOf(picture_->frame) : nullptr;
  if (recorded == nullptr) {
    return;
  }
  Capture capture = *recorded;
  const Capture& still = picture_->capture;
  capture.source = nullptr;
  capture.time = still.time;
  const std::vector<std::string>& joints = world_.set().jointNames;
  for (auto values : {&JointReadings::measured, &JointReadings::temperature, &JointReadings::current}) {
    capture.joints.*values = inRecordedOrder(still.joints.*values, recorded->joints.*values, joints);
  }
  capture.imu = recorded->imu ? still.imu : std::nullopt;
  capture.fsr = recorded->fsr ? still.fsr : std::nullopt;
  worker_.enqueue([this, capture = std::move(capture), frame = picture_->frame] {
    try {
      session_->record(capture, frame);
    } catch (...) {
      failure_ = failure_ ? failure_ : std::current_exception();
    }
  });
}

std::string ReplayedCalibration::compareWith(const std::filesystem::path& recordedResult) {
  worker_.waitUntilIdle();
  if (failure_) {
    std::rethrow_exception(failure_);
  }
  const StoredResult anew = session_->solve().result;
  const std::string replayed = fmt::format("{} captures were replayed and solved", session_->captures());
  if (!std::filesystem::exists(recordedResult)) {
    return replayed + "; the recording has no result to compare with.";
  }
  const StoredResult recorded = readResult(recordedResult);
  std::size_t same = 0;
  for (const auto& [name, value] : recorded.values) {
    const auto found = anew.values.find(name);
    same += found != anew.values.end() && found->second == value;
  }
  if (same == recorded.values.size() && anew.values.size() == same) {
    return fmt::format("{}: all {} estimates are the recorded ones, bit for bit.", replayed, same);
  }
  return fmt::format("{}: of {} recorded estimates {} are the same, bit for bit; the others differ, so program or "
                     "configuration are not those that recorded.",
                     replayed, recorded.values.size(), same);
}

} // namespace naocal

#include "hardware/replay/ReplayTimeline.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <mutex>
#include <numeric>

namespace naocal {
namespace {

using namespace std::chrono_literals;

constexpr Duration replayCycle = 12ms, leadIn = 1s, leadOut = 500ms; // before the first and after the last capture
constexpr Duration longestHold = 1min; // of a capture's readings, before and after it: sets may be days long
constexpr Duration transfer = 25ms;    // from mid-exposure to an image's arrival

/// An image file, read on first access.
class PictureFile : public ImageBytes {
public:
  PictureFile(std::filesystem::path file, const PictureSize& described)
      : file_{std::move(file)}, described_{described} {}

  std::span<const std::uint8_t> bytes() const override {
    std::call_once(read_, [this] {
      try {
        bytes_ = readImage(file_, described_).pixels;
      } catch (const InputError&) { // no picture of the camera's size, or removed since the replay began
      }
    });
    return bytes_;
  }

private:
  std::filesystem::path file_;
  PictureSize described_;
  mutable std::once_flag read_;
  mutable std::vector<std::uint8_t> bytes_;
};

/// Mid-exposure times, in the set's time, shifted by 1000 s if it starts near zero; different readings get different
/// times. Throws InputError for times that are no seconds of a robot's clock.
std::vector<TimePoint> middles(const CaptureSet& set, const std::vector<std::size_t>& order,
                               const std::filesystem::path& folder) {
  constexpr double latest = 4e9; // [s], 127 years
  for (const std::size_t end : {order.front(), order.back()}) {
    if (const Capture& capture = set.captures[end]; std::abs(capture.time.count()) > latest) {
      throw InputError{fmt::format("{}: capture {}: expected a time from -4e9 to 4e9 seconds, found {:.4g}",
                                   folder.string(), capture.id, capture.time.count())};
    }
  }
  const double first = set.captures[order.front()].time.count();
  const Duration shift = first < 10 ? Duration{1000s} : Duration{};
  std::vector<TimePoint> result(set.captures.size());
  TimePoint last{};
  const Capture* previous = nullptr;
  for (const std::size_t i : order) {
    const Capture& capture = set.captures[i];
    result[i] = TimePoint{shift + std::chrono::round<Duration>(capture.time)};
    const bool sameReading = previous && previous->joints.measured == capture.joints.measured;
    if (previous && result[i] <= last && !sameReading) {
      result[i] = last + 1ns;
    }
    last = result[i];
    previous = &capture;
  }
  return result;
}

CameraFrame frameOf(const CaptureSet& set, const Capture& capture, const std::filesystem::path& folder) {
  const bool top = capture.camera == toString(CameraName::top);
  if (!top && capture.camera != toString(CameraName::bottom)) {
    throw InputError{fmt::format("{}: capture {}: expected the top or the bottom camera, found \"{}\"; other cameras "
                                 "cannot be replayed",
                                 folder.string(), capture.id, capture.camera)};
  }
  if (capture.image.empty() || !std::filesystem::exists(folder / capture.image)) {
    throw InputError{fmt::format("{}: capture {}: expected a picture to replay, found {}", folder.string(), capture.id,
                                 capture.image.empty() ? "corners alone" : "no file " + capture.image)};
  }
  const CameraIntrinsics& camera = set.cameras.at(capture.camera);
  CameraFrame frame;
  frame.camera = top ? CameraName::top : CameraName::bottom;
  frame.format = PixelFormat::grey;
  frame.width = camera.width;
  frame.height = camera.height;
  frame.picture = std::make_shared<PictureFile>(pictureFile(capture, folder), PictureSize{camera.width, camera.height});
  return frame;
}

} // namespace

ReplayTimeline buildTimeline(const CaptureSet& set, const std::filesystem::path& folder, Duration latency) {
  if (set.captures.empty()) {
    throw InputError{fmt::format("{}: expected captures to replay, found none", folder.string())};
  }
  std::vector<std::size_t> order(set.captures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return set.captures[a].time < set.captures[b].time; });
  const std::vector<TimePoint> middle = middles(set, order, folder);

  ReplayTimeline timeline;
  std::array<std::uint64_t, 2> sequences{};
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t i = order[place];
    CameraFrame frame = frameOf(set, set.captures[i], folder);
    frame.time = middle[i] - latency;
    frame.sequence = sequences[std::size_t(frame.camera)]++;
    timeline.pictures.push_back({frame, middle[i] + transfer, i});
    // The readings hold from halfway to the previous capture until halfway to the next one, a minute at most.
    const bool isFirst = place == 0, isLast = place + 1 == order.size();
    const Duration before =
        isFirst ? leadIn : std::min<Duration>(longestHold, (middle[i] - middle[order[place - 1]]) / 2);
    const Duration after =
        isLast ? leadOut : std::min<Duration>(longestHold, (middle[order[place + 1]] - middle[i]) / 2);
    for (TimePoint time = middle[i] - before / replayCycle * replayCycle; time <= middle[i] + after;
         time += replayCycle) {
      if (timeline.moments.empty() || timeline.moments.back().time < time) {
        timeline.moments.push_back({time, i});
      }
    }
  }
  return timeline;
}

RobotState stateAtCapture(const CaptureSet& set, const Capture& capture, TimePoint time) {
  RobotState state;
  state.time = time;
  state.stiffness.fill(1);
  for (std::size_t i = 0; i < set.jointNames.size(); ++i) {
    const auto joint = jointIndex(set.jointNames[i]);
    const auto take = [&](const std::vector<double>& readings, double& to) {
      to = joint && i < readings.size() && std::isfinite(readings[i]) ? readings[i] : to;
    };
    if (joint) {
      take(capture.joints.measured, state.angles[*joint]);
      take(capture.joints.current, state.current[*joint]);
      take(capture.joints.temperature, state.temperature[*joint]);
    }
  }
  state.torsoAngles = capture.imu.value_or(Eigen::Vector2d::Zero());
  state.accelerometer = {0, 0, 9.81};
  state.forces = capture.fsr.value_or(state.forces);
  return state;
}

} // namespace naocal

#include "hardware/v4l2/VideoCameras.hpp"

#include <algorithm>
#include <poll.h>
#include <utility>

namespace naocal {
namespace {

constexpr std::chrono::milliseconds glance{50}; // polling interval for closed or hung cameras

} // namespace

VideoCameras::VideoCameras(const std::vector<VideoOptions>& cameras, VideoSystem& system)
    : system_{system}, cameras_{cameras} {
  for (const VideoOptions& camera : cameras) {
    devices_.push_back(std::make_unique<VideoDevice>(camera, system));
  }
}

std::optional<CameraFrame> VideoCameras::waitForFrame(std::chrono::milliseconds timeout) {
  const TimePoint deadline = Clock::now() + timeout;
  while (true) {
    for (const auto& device : devices_) {
      device->ensureOpen();
    }
    for (const auto& device : devices_) {
      device->drain(); // reads also images that arrived in between: the newest wins
    }
    VideoDevice* older = nullptr;
    for (const auto& device : devices_) {
      if (device->pending && (!older || device->pending->time < older->pending->time)) {
        older = device.get();
      }
    }
    if (older) {
      ++older->link.frames;
      return std::exchange(older->pending, std::nullopt);
    }
    const Duration left = deadline - Clock::now();
    if (left <= Duration{}) {
      return std::nullopt;
    }
    wait(std::min<Duration>(left, glance));
  }
}

/// Waits until a camera is ready or has failed; `drain` reports the failure.
bool VideoCameras::wait(std::chrono::nanoseconds most) {
  std::vector<pollfd> files;
  for (const auto& device : devices_) {
    if (device->file() >= 0) {
      files.push_back({device->file(), POLLIN, 0});
    }
  }
  const int ready = system_.poll(files, int(std::chrono::ceil<std::chrono::milliseconds>(most).count()));
  for (const auto& device : devices_) {
    const auto file = std::find_if(files.begin(), files.end(), [&](auto& one) { return one.fd == device->file(); });
    if (ready > 0 && file != files.end() && (file->revents & (POLLERR | POLLNVAL | POLLHUP)) &&
        !(file->revents & POLLIN)) {
      device->drain(); // sets the reason
      if (device->file() >= 0) {
        device->closeWithReason("its driver reports an error");
      }
    }
  }
  return ready > 0;
}

CameraStatus VideoCameras::status(CameraName camera) const {
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    if (cameras_[i].camera == camera) {
      return devices_[i]->link;
    }
  }
  CameraStatus absent;
  absent.problem = fmt::format("there is no {} camera", toString(camera));
  return absent;
}

void VideoCameras::configure(CameraName camera, const std::map<std::string, int>& settings) {
  for (const VideoOptions& options : cameras_) {
    std::vector<VideoControl> controls = options.controls;
    for (const auto& [name, value] : settings) { // map order: autoExposure and similar before the manual values
      if (const auto id = videoControlId(name)) {
        controls.push_back({name, *id, value});
      }
    }
    if (options.camera == camera) {
      setControls(camera, controls);
    }
  }
}

void VideoCameras::setControls(CameraName camera, const std::vector<VideoControl>& controls) {
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    if (cameras_[i].camera == camera) {
      devices_[i]->setControls(controls);
    }
  }
}

} // namespace naocal

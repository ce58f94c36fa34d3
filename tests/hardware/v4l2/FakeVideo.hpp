#pragma once

#include "hardware/v4l2/VideoSystem.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <functional>
#include <linux/uvcvideo.h>
#include <linux/videodev2.h>
#include <map>
#include <poll.h>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace naocal {

/// Fake kernel with configurable cameras. Enforces the order of calls that real drivers require.
class FakeVideo : public VideoSystem {
public:
  struct Control {
    int minimum = 0, maximum = 255, value = 0;
    int stubborn = 0; // number of settings to ignore
  };
  struct Camera {
    bool present = true;
    bool wallClock = false; // time stamps without the monotonic flag
    std::map<std::uint32_t, Control> controls;
    std::map<std::uint8_t, std::uint16_t> extensions; // by selector
    std::map<unsigned long, int> failures;            // by request: number of failures with EINVAL
    std::uint32_t width = 640, height = 480;          // size offered by the driver
    bool broken = false;                              // stream has failed: EIO until closed
    std::uint32_t sequence = 0;
    int opened = 0;
    std::function<void()> opening; // called on each attempt

    int file = -1;
    bool formatted = false, streaming = false;
    std::vector<std::vector<std::uint8_t>> memory;
    std::deque<std::uint32_t> free;
    std::deque<v4l2_buffer> filled;
    std::vector<std::uint32_t> order; // requests in order
  };
  std::map<std::string, Camera> cameras;
  std::size_t mapped = 0; // number of mapped buffers

  /// Exposes an image with all bytes `grey`; lost if no buffer is free.
  void expose(Camera& camera, std::uint8_t grey, std::chrono::nanoseconds time, std::uint32_t flags = 0) {
    expose(camera, std::vector<std::uint8_t>(2 * camera.width * camera.height, grey), time, flags);
  }
  /// Exposes an image with these bytes.
  void expose(Camera& camera, std::span<const std::uint8_t> picture, std::chrono::nanoseconds time,
              std::uint32_t flags = 0) {
    const std::uint32_t sequence = camera.sequence++;
    if (!camera.streaming || camera.free.empty()) {
      return;
    }
    v4l2_buffer buffer{};
    buffer.index = camera.free.front();
    camera.free.pop_front();
    auto& bytes = camera.memory[buffer.index];
    std::copy_n(picture.begin(), std::min(bytes.size(), picture.size()), bytes.begin());
    buffer.bytesused = std::uint32_t(bytes.size());
    buffer.sequence = sequence;
    buffer.flags = flags | (camera.wallClock ? 0 : V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC);
    buffer.timestamp.tv_sec = time.count() / 1'000'000'000;
    buffer.timestamp.tv_usec = time.count() / 1000 % 1'000'000;
    camera.filled.push_back(buffer);
  }

  int open(const std::string& path) override {
    const auto camera = cameras.find(path);
    if (camera != cameras.end() && camera->second.opening) {
      camera->second.opening();
    }
    if (camera == cameras.end() || !camera->second.present) {
      return -ENOENT;
    }
    if (camera->second.file >= 0) {
      return -EBUSY;
    }
    ++camera->second.opened;
    return camera->second.file = next_++;
  }
  void close(int file) override {
    Camera& camera = at(file);
    camera.file = -1;
    camera.formatted = camera.streaming = camera.broken = false;
    camera.free.clear();
    camera.filled.clear();
    camera.sequence = 0;
  }
  void* map(std::size_t length, int file, long offset) override {
    auto& memory = at(file).memory[std::size_t(offset)];
    ++mapped;
    return memory.size() == length ? memory.data() : nullptr;
  }
  void unmap(void*, std::size_t) override { --mapped; }
  int poll(std::span<pollfd> files, int milliseconds) override {
    int ready = 0;
    for (pollfd& one : files) {
      Camera& camera = at(one.fd);
      one.revents = short((camera.filled.empty() ? 0 : POLLIN) | (camera.broken || !camera.present ? POLLERR : 0));
      ready += one.revents != 0;
    }
    if (ready == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds{std::min(milliseconds, 1)});
    }
    return ready;
  }

  int ioctl(int file, unsigned long request, void* argument) override {
    Camera& camera = at(file);
    camera.order.push_back(std::uint32_t(request));
    if (!camera.present) {
      return -ENODEV;
    }
    if (camera.failures[request] > 0) {
      --camera.failures[request];
      return -EINVAL;
    }
    switch (request) {
    case VIDIOC_S_FMT: {
      auto& format = static_cast<v4l2_format*>(argument)->fmt.pix;
      format.width = camera.width;
      format.height = camera.height;
      format.bytesperline = 2 * camera.width;
      camera.formatted = true;
      return camera.memory.empty() || !camera.streaming ? 0 : -EBUSY;
    }
    case VIDIOC_REQBUFS: {
      if (!camera.formatted) {
        return -EINVAL;
      }
      camera.memory.assign(static_cast<v4l2_requestbuffers*>(argument)->count,
                           std::vector<std::uint8_t>(2 * camera.width * camera.height));
      return 0;
    }
    case VIDIOC_QUERYBUF: {
      auto& buffer = *static_cast<v4l2_buffer*>(argument);
      buffer.length = std::uint32_t(camera.memory.at(buffer.index).size());
      buffer.m.offset = buffer.index;
      return 0;
    }
    case VIDIOC_QBUF:
      camera.free.push_back(static_cast<v4l2_buffer*>(argument)->index);
      return 0;
    case VIDIOC_DQBUF:
      if (camera.broken) {
        return -EIO;
      }
      if (camera.filled.empty()) {
        return -EAGAIN;
      }
      *static_cast<v4l2_buffer*>(argument) = camera.filled.front();
      camera.filled.pop_front();
      return 0;
    case VIDIOC_STREAMON:
      camera.streaming = !camera.free.empty();
      return camera.streaming ? 0 : -EINVAL;
    case VIDIOC_QUERYCTRL: {
      auto& query = *static_cast<v4l2_queryctrl*>(argument);
      const auto control = camera.controls.find(query.id);
      if (control == camera.controls.end()) {
        return -EINVAL;
      }
      query.minimum = control->second.minimum;
      query.maximum = control->second.maximum;
      return 0;
    }
    case VIDIOC_S_CTRL: {
      const auto& wanted = *static_cast<v4l2_control*>(argument);
      Control& control = camera.controls.at(wanted.id);
      control.value = control.stubborn-- > 0 ? control.value : wanted.value;
      return 0;
    }
    case VIDIOC_G_CTRL: {
      auto& asked = *static_cast<v4l2_control*>(argument);
      asked.value = camera.controls.at(asked.id).value;
      return 0;
    }
    case UVCIOC_CTRL_QUERY: {
      const auto& query = *static_cast<uvc_xu_control_query*>(argument);
      if (query.unit != 3 || query.size != 2) {
        return -ENOENT;
      }
      auto& value = camera.extensions[query.selector];
      query.query == 0x01 ? std::memcpy(&value, query.data, 2) : std::memcpy(query.data, &value, 2);
      return 0;
    }
    default:
      return 0;
    }
  }

private:
  Camera& at(int file) {
    for (auto& [path, camera] : cameras) {
      if (camera.file == file) {
        return camera;
      }
    }
    throw std::logic_error{"a file that is not open"};
  }
  int next_ = 100;
};

} // namespace naocal

#pragma once

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <thread>
#include <unistd.h>
#include <vector>

/// Access to the kernel's virtual video driver (vivid): controls that inject failures, and the output that is looped
/// back to its capture device. Independent of the code under test.
namespace naocal::vivid {

/// RAII device file.
class Node {
public:
  explicit Node(const char* path) : file_{open(path, O_RDWR | O_NONBLOCK)} {
    if (file_ < 0) {
      throw std::runtime_error{std::string{path} + ": " + std::strerror(errno)};
    }
  }
  ~Node() { close(file_); }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  int file() const { return file_; }
  void call(unsigned long request, void* argument, const char* what) const {
    if (ioctl(file_, request, argument) < 0) {
      throw std::runtime_error{std::string{what} + ": " + std::strerror(errno)};
    }
  }

  /// A control by its name in the driver.
  v4l2_queryctrl control(std::string_view name) const {
    v4l2_queryctrl query{};
    query.id = V4L2_CTRL_FLAG_NEXT_CTRL;
    while (ioctl(file_, VIDIOC_QUERYCTRL, &query) == 0) {
      if (reinterpret_cast<const char*>(query.name) == name) {
        return query;
      }
      query.id |= V4L2_CTRL_FLAG_NEXT_CTRL;
    }
    throw std::runtime_error{"vivid has no control " + std::string{name}};
  }
  void set(std::string_view name, int value) const {
    v4l2_control setting{control(name).id, value};
    call(VIDIOC_S_CTRL, &setting, "S_CTRL");
  }

private:
  int file_;
};

inline constexpr int webcam = 0, hdmi = 3; // inputs, by input_types=0xe4

/// Shows one image repeatedly at an output that is looped back to the capture device (input hdmi).
class Feeder {
public:
  Feeder(const char* capture, const char* output, const std::vector<std::uint8_t>& picture) : output_{output} {
    v4l2_dv_timings timings = vga();
    const Node input{capture};
    int connector = hdmi;
    input.call(VIDIOC_S_INPUT, &connector, "S_INPUT");
    input.call(VIDIOC_S_DV_TIMINGS, &timings, "S_DV_TIMINGS");
    connector = 1;
    output_.call(VIDIOC_S_OUTPUT, &connector, "S_OUTPUT");
    output_.call(VIDIOC_S_DV_TIMINGS, &timings, "S_DV_TIMINGS");
    input.set("OSD Text Mode", 2);
    input.set("Loop Video", 1);

    v4l2_format format{};
    format.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
    format.fmt.pix.width = 640;
    format.fmt.pix.height = 480;
    format.fmt.pix.pixelformat = V4L2_PIX_FMT_YUYV;
    format.fmt.pix.field = V4L2_FIELD_NONE;
    output_.call(VIDIOC_S_FMT, &format, "S_FMT");
    v4l2_requestbuffers request{};
    request.count = 4;
    request.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
    request.memory = V4L2_MEMORY_MMAP;
    output_.call(VIDIOC_REQBUFS, &request, "REQBUFS");
    for (std::uint32_t index = 0; index < request.count; ++index) {
      v4l2_buffer buffer{};
      buffer.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
      buffer.memory = V4L2_MEMORY_MMAP;
      buffer.index = index;
      output_.call(VIDIOC_QUERYBUF, &buffer, "QUERYBUF");
      void* const memory =
          mmap(nullptr, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED, output_.file(), buffer.m.offset);
      std::memcpy(memory, picture.data(), picture.size());
      munmap(memory, buffer.length);
      buffer.bytesused = std::uint32_t(picture.size());
      buffer.field = V4L2_FIELD_NONE;
      output_.call(VIDIOC_QBUF, &buffer, "QBUF");
    }
    int type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
    output_.call(VIDIOC_STREAMON, &type, "STREAMON");
    thread_ = std::jthread{[this, size = std::uint32_t(picture.size())](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        pollfd ready{output_.file(), POLLOUT, 0};
        v4l2_buffer buffer{};
        buffer.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
        buffer.memory = V4L2_MEMORY_MMAP;
        if (poll(&ready, 1, 100) > 0 && ioctl(output_.file(), VIDIOC_DQBUF, &buffer) == 0) {
          buffer.bytesused = size;
          ioctl(output_.file(), VIDIOC_QBUF, &buffer);
        }
      }
    }};
  }

private:
  /// 640 x 480 at 60 Hz (DMT, CEA-861).
  static v4l2_dv_timings vga() {
    v4l2_dv_timings timings{};
    timings.type = V4L2_DV_BT_656_1120;
    v4l2_bt_timings& bt = timings.bt;
    bt.width = 640;
    bt.height = 480;
    bt.pixelclock = 25'175'000;
    bt.hfrontporch = 16;
    bt.hsync = 96;
    bt.hbackporch = 48;
    bt.vfrontporch = 10;
    bt.vsync = 2;
    bt.vbackporch = 33;
    bt.standards = V4L2_DV_BT_STD_DMT | V4L2_DV_BT_STD_CEA861;
    return timings;
  }

  Node output_;
  std::jthread thread_;
};

} // namespace naocal::vivid

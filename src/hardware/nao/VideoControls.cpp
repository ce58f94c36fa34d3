#include "hardware/nao/VideoDevice.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <linux/usb/video.h>
#include <linux/uvcvideo.h>
#include <linux/videodev2.h>
#include <thread>

namespace naocal {

namespace {

constexpr int tries = 3;
constexpr std::chrono::milliseconds betweenTries{20}; // NAO's cameras take a frame to follow

/// Sets until it reads back right; the reason why it does not, else nothing. Both return what the kernel does.
template <typename Set, typename Get> std::string insist(const Set& set, const Get& get, int wanted) {
  std::string reason;
  for (int attempt = 0; attempt < tries; ++attempt) {
    if (attempt > 0) {
      std::this_thread::sleep_for(betweenTries);
    }
    int now = 0;
    int result = set();
    result = result < 0 ? result : get(now);
    if (result >= 0 && now == wanted) {
      return "";
    }
    reason = result < 0 ? std::strerror(-result) : fmt::format("it stays at {}", now).c_str();
  }
  return reason;
}

} // namespace

void VideoDevice::set(std::vector<VideoControl> controls) {
  options_.controls = std::move(controls);
  if (file_ >= 0) {
    link.problem.clear();
    apply();
  }
}

/// The last refusal stands in `link.problem`; pictures are taken all the same.
void VideoDevice::apply() {
  const auto note = [&](const std::string& refused) {
    if (!refused.empty()) {
      link.problem = fmt::format("{} ({} camera): {}", options_.path, toString(options_.camera), refused);
    }
  };
  for (const VideoExtension& extension : options_.extensions) {
    note(refusal(extension));
  }
  for (const VideoControl& control : options_.controls) {
    note(refusal(control));
  }
}

std::string VideoDevice::refusal(const VideoControl& control) {
  v4l2_queryctrl range{};
  range.id = control.id;
  if (system_.ioctl(file_, VIDIOC_QUERYCTRL, &range) < 0 || (range.flags & V4L2_CTRL_FLAG_DISABLED)) {
    return fmt::format("it has no {}", control.name);
  }
  if (control.value < range.minimum || control.value > range.maximum) {
    return fmt::format("its {} can be {} to {}, not {}", control.name, range.minimum, range.maximum, control.value);
  }
  v4l2_control value{control.id, control.value};
  const std::string reason = insist(
      [&] {
        value.value = control.value;
        return system_.ioctl(file_, VIDIOC_S_CTRL, &value);
      },
      [&](int& now) {
        const int result = system_.ioctl(file_, VIDIOC_G_CTRL, &value);
        now = value.value;
        return result;
      },
      control.value);
  return reason.empty() ? ""
                        : fmt::format("its {} does not take the value {}: {}", control.name, control.value, reason);
}

std::string VideoDevice::refusal(const VideoExtension& extension) {
  std::uint16_t value = 0;
  const auto query = [&](std::uint8_t what) {
    uvc_xu_control_query request{extension.unit, extension.selector, what, sizeof value,
                                 reinterpret_cast<std::uint8_t*>(&value)}; // little endian, as all NAOs are
    return system_.ioctl(file_, UVCIOC_CTRL_QUERY, &request);
  };
  const std::string reason = insist(
      [&] {
        value = extension.value;
        return query(UVC_SET_CUR);
      },
      [&](int& now) {
        value = 0;
        const int result = query(UVC_GET_CUR);
        now = value;
        return result;
      },
      extension.value);
  return reason.empty() ? ""
                        : fmt::format("its {} does not take the value {}: {}", extension.name, extension.value, reason);
}

} // namespace naocal

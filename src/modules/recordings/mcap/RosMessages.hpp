#pragma once

#include "data/Capture.hpp"
#include "io/GreyImage.hpp"

#include <chrono>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace naocal {

/// sensor_msgs/msg/JointState: angles by joint; other lists are not needed.
struct RosJointState {
  std::chrono::nanoseconds stamp{};
  std::vector<std::string> names;
  std::vector<double> positions; // [rad], [m]
};

/// sensor_msgs/msg/Image with its pixels as luma, or CompressedImage with its file.
struct RosImage {
  std::chrono::nanoseconds stamp{};
  std::string frame; // link of the camera
  std::variant<GreyPicture, std::string> content;
};

/// sensor_msgs/msg/CameraInfo.
struct RosCameraLens {
  std::string frame; // link of the camera
  CameraIntrinsics lens;
};

/// Parse a ROS 2 message serialised as CDR; `where` begins messages. Throw InputError with expected and found: other
/// encodings than CDR, data that end too early, lists of different lengths, numbers that are none, pictures with an
/// encoding other than mono8, 8UC1, rgb8, 8UC3, bgr8, rgba8, bgra8, yuv422_yuy2 and uyvy, lens models other than
/// plumb_bob with at most five coefficients. Sources: ROS 2's common_interfaces; OMG's DDSI-RTPS 10.5.
RosJointState parseJointState(std::string_view data, const std::string& where);
RosImage parseImage(std::string_view data, const std::string& where);
RosImage parseCompressedImage(std::string_view data, const std::string& where);
RosCameraLens parseCameraInfo(std::string_view data, const std::string& where);

/// The stamp of a message that begins with a header.
std::chrono::nanoseconds parseStamp(std::string_view data, const std::string& where);

} // namespace naocal

#include "dialects/heads/BitBots.hpp"

#include "dialects/MountAngles.hpp"
#include "dialects/text/Decimals.hpp"
#include "dialects/text/InPlaceText.hpp"

#include <array>

namespace naocal {

namespace {

constexpr std::array angleKeys{"offset_x", "offset_y", "offset_z"};

YamlCursor cameraNode(const YamlCursor& top) {
  return top.at("/bitbots_extrinsic_camera_calibration").at("ros__parameters");
}

/// ROS would take a whole number for another type.
std::string printRosAngle(double angle) {
  const std::string number = printRadian(angle);
  return number.find('.') == std::string::npos ? number + ".0" : number;
}

/// neckFromUncalibrated.
Eigen::Matrix3d uncalibratedFrame(const Robot& robot, const HeadCamera& head) {
  constexpr const char* older = "camera_optical_frame_uncalibrated";
  return placeOnNeck(robot, head, robot.linkIndex(older) ? older : "camera_optical_frame_left_uncalibrated").rotation;
}

} // namespace

std::string writeBitBots(const std::string& text, const std::string& file, const Robot& robot, const HeadCamera& head) {
  InPlaceText edited{text, file, InPlaceSyntax::yaml};
  const YamlCursor node = cameraNode(edited.top());
  const Eigen::Matrix3d frame = uncalibratedFrame(robot, head);
  if (head.calibrated) {
    edited.replace(node.at(angleKeys),
                   anglesZyx(frame.transpose() * head.calibrated->rotation * opticalFromCamera().transpose()),
                   printRosAngle);
  }
  return edited.edited();
}

HeadDirection parseBitBots(const std::string& text, const std::string& file, const Robot& robot,
                           const HeadCamera& head) {
  const InPlaceText given{text, file, InPlaceSyntax::yaml};
  const YamlCursor node = cameraNode(given.top());
  Eigen::Vector3d angles;
  for (std::size_t i = 0; i < angleKeys.size(); ++i) {
    angles[static_cast<Eigen::Index>(i)] = node.at(angleKeys[i]).number();
  }
  return {uncalibratedFrame(robot, head) * rotationZyx(angles) * opticalFromCamera(), {}, {}};
}

} // namespace naocal

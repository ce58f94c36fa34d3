#include "dialects/heads/HulksK1.hpp"

#include "dialects/MountAngles.hpp"
#include "dialects/text/Decimals.hpp"
#include "dialects/text/InPlaceText.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <fmt/format.h>

namespace naocal {

namespace {

constexpr double noTurn = 1e-9; // [rad]

/// Where the corrections stand: HULKs moved them.
YamlCursor findCorrections(const YamlCursor& top) {
  constexpr const char *group = "camera_matrix_parameters", *correction = "correction_in_camera";
  if (!top.has(group)) {
    return top;
  }
  if (top.has(correction)) {
    top.refuse(fmt::format("{} once, at the top or in {}", correction, group), "both");
  }
  return top.at(group);
}

Eigen::Matrix3d readTurn(const YamlCursor& at) {
  return rotationZyx(Eigen::Vector3d{at.numbers(3).data()});
}

void writeTurn(const YamlCursor& at, const Eigen::Vector3d& angles, InPlaceText& text) {
  (void)at.numbers(3);
  text.replace(at.elements(), angles, printRadian);
}

/// opticalFromHead without correction_in_camera.
Eigen::Matrix3d opticalFromHead(const YamlCursor& corrections) {
  return rotationX(-radians(corrections.at("camera_to_head_pitch").number())) * opticalFromCamera();
}

void requireK1(const HeadCamera& head, const std::string& file) {
  requireAxis(head.neckAxis, Eigen::Vector3d::UnitY(), head.neckJoint, file);
  if (!head.base) {
    throw InputError{fmt::format("{}: expected a head that yaws on the trunk and pitches on that, as a K1's; found {} "
                                 "on another joint",
                                 file, head.neckJoint)};
  }
  requireAxis(head.base->axis, Eigen::Vector3d::UnitZ(), head.base->name, file);
}

} // namespace

std::string writeHulksK1(const std::string& text, const std::string& file, const Robot&, const HeadCamera& head) {
  requireK1(head, file);
  InPlaceText edited{text, file, InPlaceSyntax::json5};
  const YamlCursor corrections = findCorrections(edited.top());
  if (head.base->offset) {
    writeTurn(corrections.at("correction_in_robot"), {0, 0, *head.base->offset}, edited);
  }
  if (head.calibrated) {
    const Eigen::Matrix3d inCamera =
        opticalFromCamera() * head.calibrated->rotation.transpose() * opticalFromHead(corrections).transpose();
    writeTurn(corrections.at("correction_in_camera"), anglesZyx(inCamera), edited);
  }
  return edited.edited();
}

HeadDirection parseHulksK1(const std::string& text, const std::string& file, const Robot&, const HeadCamera& head) {
  requireK1(head, file);
  const InPlaceText given{text, file, InPlaceSyntax::json5};
  const YamlCursor corrections = findCorrections(given.top());
  HeadDirection direction;
  direction.neckFromCamera =
      (readTurn(corrections.at("correction_in_camera")) * opticalFromHead(corrections)).transpose() *
      opticalFromCamera();
  const Eigen::Vector3d inRobot = anglesZyx(readTurn(corrections.at("correction_in_robot")));
  direction.baseOffset = inRobot.z();
  if (inRobot.head<2>().norm() > noTurn) {
    direction.unused.push_back(fmt::format(
        "correction_in_robot about x and y ({:.4f}°, {:.4f}°): the trunk's tilt is no part of a calibration",
        degrees(inRobot.x()), degrees(inRobot.y())));
  }
  return direction;
}

} // namespace naocal

#include "dialects/heads/NUbots.hpp"

#include "dialects/MountAngles.hpp"
#include "dialects/text/Decimals.hpp"
#include "dialects/text/InPlaceText.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <muParser.h>
#include <numbers>
#include <optional>

namespace naocal {

namespace {

constexpr std::array offsetKeys{"roll_offset", "pitch_offset", "yaw_offset"};
constexpr const char *pitchFrame = "Hpc", *anglesOfFrame = "rotation_rpy";

/// Value of an expression such as "1.5 * pi / 180" [rad].
double evaluateAngle(const YamlCursor& at) {
  double value = std::nan("");
  try {
    mu::Parser parser;
    parser.DefineConst("pi", std::numbers::pi);
    parser.SetExpr(at.text());
    value = parser.Eval();
  } catch (const mu::Parser::exception_type&) { // refused below
  }
  if (!std::isfinite(value)) {
    at.refuse("an angle such as 1.5 * pi / 180", fmt::format("\"{}\"", at.text()));
  }
  return value;
}

/// For example "1.5 * pi / 180".
std::string printExpression(double angle) {
  return printDecimal(degrees(angle), decimals::degree) + " * pi / 180";
}

/// Angles (roll, pitch, yaw) with r = Rx(yaw) Rz(pitch) Ry(roll).
Eigen::Vector3d offsetAngles(const Eigen::Matrix3d& r) {
  return {std::atan2(r(0, 2), r(0, 0)), std::asin(std::clamp(-r(0, 1), -1.0, 1.0)), std::atan2(r(2, 1), r(1, 1))};
}

Eigen::Matrix3d offsetRotation(const Eigen::Vector3d& angles) {
  return rotationX(angles.z()) * rotationZ(angles.y()) * rotationY(angles.x());
}

/// What of a file belongs to the camera's direction.
struct NUbotsPlaces {
  std::optional<YamlCursor> offsets;                  // what holds the three offsets
  std::optional<YamlCursor> angles;                   // else the frame's own angles
  Eigen::Matrix3d base = Eigen::Matrix3d::Identity(); // neckFromCamera without the offsets
};

NUbotsPlaces findPlaces(const YamlCursor& top, const std::string& file, const Robot& robot, const HeadCamera& head) {
  NUbotsPlaces places;
  if (top.has(pitchFrame)) { // K1
    requireAxis(head.neckAxis, Eigen::Vector3d::UnitY(), head.neckJoint, file);
    const YamlCursor frame = top.at(pitchFrame);
    places.angles = frame.at(anglesOfFrame);
    places.base = rotationZyx(Eigen::Vector3d{places.angles->numbers(3).data()});
    if (frame.has(offsetKeys[0])) {
      places.offsets = frame;
    }
    return places;
  }
  if (!top.has(offsetKeys[0])) {
    top.refuse("roll_offset, pitch_offset and yaw_offset (Cameras/Left.yaml) or Hpc (K1Sensors.yaml)", "neither");
  }
  if (head.neckLink != "head") {
    throw InputError{
        fmt::format("{}: expected the camera of a NUgus, on its link head, found one on {}", file, head.neckLink)};
  }
  const bool isRight = top.has("is_left_camera") && top.at("is_left_camera").text() == "false";
  places.offsets = top;
  places.base = placeOnNeck(robot, head, isRight ? "right_camera" : "left_camera").rotation;
  return places;
}

} // namespace

std::string writeNUbots(const std::string& text, const std::string& file, const Robot& robot, const HeadCamera& head) {
  InPlaceText edited{text, file, InPlaceSyntax::yaml};
  const NUbotsPlaces places = findPlaces(edited.top(), file, robot, head);
  if (!head.calibrated) {
    return text;
  }
  if (places.offsets) {
    const Eigen::Vector3d angles = offsetAngles(head.calibrated->rotation * places.base.transpose());
    edited.replace(places.offsets->at(offsetKeys), angles, printExpression);
  } else {
    edited.replace(places.angles->elements(), anglesZyx(head.calibrated->rotation), printRadian);
  }
  return edited.edited();
}

HeadDirection parseNUbots(const std::string& text, const std::string& file, const Robot& robot,
                          const HeadCamera& head) {
  const InPlaceText given{text, file, InPlaceSyntax::yaml};
  const NUbotsPlaces places = findPlaces(given.top(), file, robot, head);
  Eigen::Matrix3d offset = Eigen::Matrix3d::Identity();
  if (places.offsets) {
    Eigen::Vector3d angles;
    for (std::size_t i = 0; i < offsetKeys.size(); ++i) {
      angles[static_cast<Eigen::Index>(i)] = evaluateAngle(places.offsets->at(offsetKeys[i]));
    }
    offset = offsetRotation(angles);
  }
  return {offset * places.base, {}, {}};
}

} // namespace naocal

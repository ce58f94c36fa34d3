#include "captures/CaptureReader.hpp"

#include "captures/CaptureWords.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <set>

namespace naocal {
namespace {

/// One motor has one angle: both names may differ by the rounding of a log, at most by about an encoder step (1.5e-3).
constexpr double hipYawPitchTolerance = 2e-3; // [rad]

/// A corner is measured inside the image; noise and gross errors may carry it this far out, another resolution further.
constexpr double imageMargin = 20; // [px]

void requireOneHipYawPitch(const std::vector<double>& measured, const CaptureSet& set, const JsonPlace& place) {
  const auto angle = [&](std::string_view joint) {
    const auto name = std::find(set.jointNames.begin(), set.jointNames.end(), joint);
    return name == set.jointNames.end() ? std::numeric_limits<double>::quiet_NaN()
                                        : measured[static_cast<std::size_t>(name - set.jointNames.begin())];
  };
  const double left = angle("LHipYawPitch"), right = angle("RHipYawPitch");
  if (std::abs(left - right) > hipYawPitchTolerance) {
    place.refuse("one angle for LHipYawPitch and RHipYawPitch, which are one motor",
                 fmt::format("{} and {} rad", left, right));
  }
}

JointReadings readJoints(const JsonPlace& place, const CaptureSet& set) {
  JointReadings joints;
  place.at("measured");
  for (const JointList& list : jointLists) {
    const auto given = place.find(list.key);
    if (!given) {
      continue;
    }
    auto& values = joints.*list.values;
    values = given->numbers(set.jointNames.size(), list.range, "one per name in jointNames", true);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(values[i]) && !std::isnan(joints.measured[i])) { // null is for joints that were not recorded
        given->elements()[i].number(list.range);
      }
    }
  }
  for (std::size_t i = 0; i < joints.approach.size(); ++i) {
    if (joints.approach[i] != std::round(joints.approach[i]) && !std::isnan(joints.approach[i])) {
      place.at("approach").elements()[i].refuse("-1, 0 or +1");
    }
  }
  requireOneHipYawPitch(joints.measured, set, place.at("measured"));
  return joints;
}

BoardCorners readBoardCorners(const JsonPlace& place, const CaptureSet& set, const CameraIntrinsics& camera) {
  BoardCorners corners;
  corners.board = place.at("board").text();
  const auto board = std::find_if(set.boards.begin(), set.boards.end(),
                                  [&](const Board& candidate) { return candidate.id == corners.board; });
  if (board == set.boards.end()) {
    place.at("board").refuse("the id of one of the set's `boards`");
  }
  std::set<int> seen;
  for (const JsonPlace& id : place.at("ids").elements()) {
    corners.ids.push_back(id.integer(0, static_cast<int>(board->points.size()) - 1));
    if (!seen.insert(corners.ids.back()).second) {
      id.refuse("every corner of a board once per picture");
    }
  }
  const JsonPlace uv = place.at("uv");
  const auto pairs = uv.elements();
  if (pairs.size() != corners.ids.size()) {
    uv.refuse(fmt::format("a list of {} pairs (one per entry of `ids`)", corners.ids.size()));
  }
  for (const JsonPlace& pair : pairs) {
    pair.numbers(2, {-1e9, 1e9, "px"}, "u, v");
    const auto uAndV = pair.elements();
    corners.uv.emplace_back(uAndV[0].number({-imageMargin, camera.width + imageMargin, "px"}),
                            uAndV[1].number({-imageMargin, camera.height + imageMargin, "px"}));
  }
  return corners;
}

std::vector<BoardCorners> readCorners(const JsonPlace& place, const CaptureSet& set, const CameraIntrinsics& camera) {
  std::vector<BoardCorners> corners;
  std::set<std::string> boards;
  for (const JsonPlace& entry : place.elements()) {
    corners.push_back(readBoardCorners(entry, set, camera));
    if (!boards.insert(corners.back().board).second) {
      entry.at("board").refuse("every board once per capture");
    }
  }
  return corners;
}

std::string readImage(const JsonPlace& place) {
  const std::filesystem::path image = place.text();
  if (image.is_absolute() || std::find(image.begin(), image.end(), "..") != image.end()) {
    place.refuse("a path inside the set's folder, such as images/0000.png");
  }
  return image.string();
}

} // namespace

Capture readCapture(const JsonPlace& place, const CaptureSet& set) {
  Capture capture;
  capture.id = place.at("id").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  capture.pose = place.at("pose").text();
  capture.repeat = place.at("repeat").integer(0, std::numeric_limits<int>::max());
  if (const auto kind = place.find("repeatKind")) {
    capture.repeatKind = static_cast<RepeatKind>(kind->oneOf(repeatKindWords));
  }
  capture.time = Seconds{place.at("time").number({-1e12, 1e12, "s"})};
  capture.camera = place.at("camera").text();
  const auto camera = set.cameras.find(capture.camera);
  if (camera == set.cameras.end()) {
    place.at("camera").refuse("the name of one of the set's `cameras`");
  }
  capture.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").oneOf(supportFootWords));
  capture.stance = place.at("stance").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  if (std::none_of(set.stances.begin(), set.stances.end(), [&](const Stance& s) { return s.id == capture.stance; })) {
    place.at("stance").refuse("the id of one of the set's `stances`");
  }
  capture.joints = readJoints(place.at("joints"), set);
  if (const auto imu = place.find("imu")) {
    capture.imu = Eigen::Vector2d{imu->at("angleX").number(angleRange), imu->at("angleY").number(angleRange)};
  }
  if (const auto fsr = place.find("fsr")) {
    const auto values = fsr->numbers(8, {-1000, 1000, "kg"}, "left FL, FR, RL, RR, then right");
    std::copy(values.begin(), values.end(), capture.fsr.emplace().begin());
  }
  if (const auto image = place.find("image")) {
    capture.image = readImage(*image);
  }
  if (const auto corners = place.find("corners")) {
    capture.corners = readCorners(*corners, set, camera->second);
  } else if (capture.image.empty()) {
    place.refuse("`corners`, or an `image` to find them in", "neither");
  }
  return capture;
}

} // namespace naocal

#include "data/CaptureFile.hpp"

#include "data/BoardFile.hpp"
#include "data/InstrumentFile.hpp"
#include "io/JsonWriter.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>

namespace naocal {

namespace {

using nlohmann::json;
using Written = nlohmann::ordered_json;

/// A list under `joints`, with the range of its values.
struct JointList {
  const char* key;
  std::vector<double> JointReadings::*values;
  Range range;
  bool isOfSome = false; // some joints have no sensor for it
};

constexpr std::array<JointList, 6> jointLists{{
    {"measured", &JointReadings::measured, angleRange},
    {"commanded", &JointReadings::commanded, angleRange},
    {"velocity", &JointReadings::velocity, {-100, 100, "rad/s"}},
    {"approach", &JointReadings::approach, {-1, 1, "(-1, 0 or +1)"}},
    {"temperature", &JointReadings::temperature, {-100, 500, "degrees Celsius"}, true},
    {"current", &JointReadings::current, {-100, 100, "A"}},
}};

/// Both names belong to one motor: values may differ by the rounding of a log, at most about one encoder step (1.5e-3).
constexpr double hipYawPitchTolerance = 2e-3; // [rad]

/// Corners are measured inside the image. Noise and gross errors may exceed it by this much; more indicates another
/// resolution.
constexpr double imageMargin = 20; // [px]

void requireOneHipYawPitch(const std::vector<double>& measured, const CaptureSet& set, const JsonCursor& place) {
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

/// Reads one list under `joints`; NaN stands for null, which is valid where `measured` has it too, or of a joint
/// without a sensor.
std::vector<double> readJointList(const JsonCursor& place, const JointList& list, const JointReadings& joints,
                                  SetReading& reading) {
  std::vector<double> values;
  const std::size_t count = reading.set.jointNames.size();
  const bool isListOfAll = place.value().is_array() && place.value().size() == count;
  if (reading.refusals.isCollecting() && isListOfAll) { // refuses number by number
    for (const JsonCursor& element : place.elements()) {
      values.push_back(std::numeric_limits<double>::quiet_NaN());
      reading.refusals.attempt(
          [&] { values.back() = element.value().is_null() ? values.back() : element.number(list.range); });
    }
  } else {
    values = place.numbers(count, list.range, "one per name in jointNames", true);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool isRecorded = i < joints.measured.size() && !std::isnan(joints.measured[i]);
    if (std::isnan(values[i]) && isRecorded && !list.isOfSome && place.value()[i].is_null()) {
      reading.refusals.attempt([&] { place.elements()[i].number(list.range); });
    }
  }
  return values;
}

JointReadings readJoints(const JsonCursor& place, SetReading& reading) {
  JointReadings joints;
  reading.refusals.attempt([&] { place.at("measured"); });
  for (const JointList& list : jointLists) {
    const auto given = place.find(list.key);
    if (given && reading.knowsJoints) {
      reading.refusals.attempt([&] { joints.*list.values = readJointList(*given, list, joints, reading); });
    }
  }
  for (std::size_t i = 0; i < joints.approach.size(); ++i) {
    if (joints.approach[i] != std::round(joints.approach[i]) && !std::isnan(joints.approach[i])) {
      reading.refusals.attempt([&] { place.at("approach").elements()[i].refuse("-1, 0 or +1"); });
    }
  }
  if (joints.measured.size() == reading.set.jointNames.size()) {
    reading.refusals.attempt([&] { requireOneHipYawPitch(joints.measured, reading.set, place.at("measured")); });
  }
  return joints;
}

/// `camera`: nullptr if it was refused; corners are then not compared with its image.
BoardCorners readBoardCorners(const JsonCursor& place, const CameraIntrinsics* camera, SetReading& reading) {
  const CaptureSet& set = reading.set;
  Refusals& refusals = reading.refusals;
  BoardCorners corners;
  corners.board = place.at("board").text();
  const auto board = std::find_if(set.boards.begin(), set.boards.end(),
                                  [&](const Board& candidate) { return candidate.id == corners.board; });
  const bool isKnown = board != set.boards.end();
  if (!isKnown && reading.knowsBoards && !reading.refusedBoards.contains(corners.board)) {
    refusals.attempt([&] { place.at("board").refuse("the id of one of the set's `boards`"); });
  }
  std::set<int> seen;
  const auto ids = place.at("ids").elements();
  for (const JsonCursor& id : ids) {
    refusals.attempt([&] {
      corners.ids.push_back(id.integer(0, isKnown ? static_cast<int>(board->points.size()) - 1 : maxInteger));
      if (!seen.insert(corners.ids.back()).second) {
        id.refuse("every corner of a board once per picture");
      }
    });
  }
  const JsonCursor uv = place.at("uv");
  const auto pairs = uv.elements();
  if (pairs.size() != ids.size()) {
    uv.refuse(fmt::format("a list of {} pairs (one per entry of `ids`)", ids.size()));
  }
  const double anywhere = 1e9;
  for (const JsonCursor& pair : pairs) {
    refusals.attempt([&] {
      pair.numbers(2, {-anywhere, anywhere, "px"}, "u, v");
      const auto uAndV = pair.elements();
      const double right = camera != nullptr ? camera->width + imageMargin : anywhere,
                   below = camera != nullptr ? camera->height + imageMargin : anywhere;
      corners.uv.emplace_back(uAndV[0].number({camera != nullptr ? -imageMargin : -anywhere, right, "px"}),
                              uAndV[1].number({camera != nullptr ? -imageMargin : -anywhere, below, "px"}));
    });
  }
  return corners;
}

std::vector<BoardCorners> readCorners(const JsonCursor& place, const CameraIntrinsics* camera, SetReading& reading) {
  std::vector<BoardCorners> corners;
  std::set<std::string> boards;
  for (const JsonCursor& entry : place.elements()) {
    reading.refusals.attempt([&] {
      corners.push_back(readBoardCorners(entry, camera, reading));
      if (!boards.insert(corners.back().board).second) {
        entry.at("board").refuse("every board once per capture");
      }
    });
  }
  return corners;
}

std::string readImagePath(const JsonCursor& place) {
  const std::filesystem::path image = place.text();
  if (image.is_absolute() || std::find(image.begin(), image.end(), "..") != image.end()) {
    place.refuse("a path inside the set's folder, such as images/0000.png");
  }
  return image.string();
}

/// Writes NaN (joint not recorded) as null.
Written numbersJson(const std::vector<double>& numbers, bool whole) {
  Written list = Written::array();
  for (const double number : numbers) {
    list.push_back(whole && !std::isnan(number) ? Written(std::lround(number)) : Written(number));
  }
  return list;
}

Written jointsJson(const JointReadings& joints, const json& read) {
  auto known = Written::object();
  for (const JointList& list : jointLists) {
    const auto& values = joints.*list.values;
    const bool isWritten = !values.empty() || list.values == &JointReadings::measured;
    known[list.key] = isWritten ? numbersJson(values, list.values == &JointReadings::approach) : Written();
  }
  return mergeUnknownKeys(known, read);
}

Written cornersJson(const BoardCorners& corners, const json& read) {
  Written uv = Written::array();
  for (const Eigen::Vector2d& corner : corners.uv) {
    uv.push_back({corner.x(), corner.y()});
  }
  return mergeUnknownKeys({{"board", corners.board}, {"ids", corners.ids}, {"uv", uv}}, read);
}

} // namespace

Capture readCapture(const JsonCursor& place, SetReading& reading) {
  const CaptureSet& set = reading.set;
  Refusals& refusals = reading.refusals;
  Capture capture;
  refusals.attempt(
      [&] { capture.id = place.at("id").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()); });
  refusals.attempt([&] { capture.pose = place.at("pose").text(); });
  refusals.attempt([&] { capture.repeat = place.at("repeat").integer(0, std::numeric_limits<int>::max()); });
  if (const auto kind = place.find("repeatKind")) {
    refusals.attempt([&] { capture.repeatKind = static_cast<RepeatKind>(kind->wordIndex(repeatKindWords)); });
  }
  refusals.attempt([&] { capture.time = Seconds{place.at("time").number({-1e12, 1e12, "s"})}; });
  const bool isModel = set.urdf.empty(), mayBeWithoutPicture = set.version > 1;
  const CameraIntrinsics* camera = nullptr;
  const bool hasPicture = !mayBeWithoutPicture || place.find("camera") || place.find("corners") || place.find("image");
  refusals.attempt([&] {
    if (!hasPicture) {
      return;
    }
    capture.camera = place.at("camera").text();
    const auto named = set.cameras.find(capture.camera);
    camera = named == set.cameras.end() ? nullptr : &named->second;
    if (camera == nullptr && reading.knowsCameras && !reading.refusedCameras.contains(capture.camera)) {
      place.at("camera").refuse("the name of one of the set's `cameras`");
    }
  });
  capture.supportFoot = SupportFoot::none;
  if (isModel) {
    refusals.attempt(
        [&] { capture.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").wordIndex(supportFootWords)); });
  }
  refusals.attempt([&] {
    capture.stance = place.at("stance").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    const bool isKnown = std::any_of(set.stances.begin(), set.stances.end(),
                                     [&](const Stance& candidate) { return candidate.id == capture.stance; });
    if (!isKnown && reading.knowsStances && !reading.refusedStances.contains(capture.stance)) {
      place.at("stance").refuse("the id of one of the set's `stances`");
    }
  });
  refusals.attempt([&] { capture.joints = readJoints(place.at("joints"), reading); });
  if (const auto imu = place.find("imu")) {
    refusals.attempt([&] {
      capture.imu = Eigen::Vector2d{imu->at("angleX").number(angleRange), imu->at("angleY").number(angleRange)};
    });
  }
  if (const auto fsr = place.find("fsr")) {
    refusals.attempt([&] {
      const auto values = fsr->numbers(8, {-1000, 1000, "kg"}, "left FL, FR, RL, RR, then right");
      std::copy(values.begin(), values.end(), capture.fsr.emplace().begin());
    });
  }
  const auto image = place.find("image");
  if (image) {
    refusals.attempt([&] { capture.image = readImagePath(*image); });
  }
  if (const auto corners = place.find("corners")) {
    refusals.attempt([&] { capture.corners = readCorners(*corners, camera, reading); });
  } else if (!image && hasPicture) {
    refusals.attempt([&] { place.refuse("`corners`, or an `image` to find them in", "neither"); });
  }
  if (set.version > 1) {
    readInstrumentReadings(place, reading, capture);
  }
  if (!hasPicture && capture.points.empty() && capture.frames.empty() && capture.contacts.empty()) {
    refusals.attempt([&] { place.refuse("`corners`, `points`, `frames` or `contacts`", "none of them"); });
  }
  return capture;
}

nlohmann::ordered_json captureJson(const Capture& capture, bool isModel, const nlohmann::json& read) {
  Written known{
      {"id", capture.id},
      {"pose", capture.pose},
      {"repeat", capture.repeat},
      {"repeatKind", repeatKindWords[static_cast<std::size_t>(capture.repeatKind)]},
      {"time", capture.time.count()},
      {"camera", capture.camera.empty() ? Written() : Written(capture.camera)},
      {"supportFoot", isModel ? Written(supportFootWords[static_cast<std::size_t>(capture.supportFoot)]) : Written()},
      {"stance", capture.stance},
      {"joints", jointsJson(capture.joints, childOrNull(read, "joints"))},
      {"imu", nullptr},
      {"fsr", capture.fsr ? Written(*capture.fsr) : Written()},
      {"image", capture.image.empty() ? Written() : Written(capture.image)},
      {"corners", nullptr}};
  if (capture.imu) {
    known["imu"] =
        mergeUnknownKeys({{"angleX", capture.imu->x()}, {"angleY", capture.imu->y()}}, childOrNull(read, "imu"));
  }
  if (capture.corners) {
    known["corners"] = Written::array();
    for (const BoardCorners& corners : *capture.corners) {
      known["corners"].push_back(
          cornersJson(corners, entryOrNull("board", corners.board, childOrNull(read, "corners"))));
    }
  }
  known.update(instrumentReadingsJson(capture, read));
  return mergeUnknownKeys(known, read);
}

} // namespace naocal

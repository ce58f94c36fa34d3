#include "data/CaptureSetFile.hpp"

#include "data/BoardFile.hpp"
#include "data/Capture.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/Folders.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "io/JsonWriter.hpp"
#include "io/Refusals.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <set>

namespace naocal {

namespace {

/// A list under `joints`, with the range of its values.
struct JointList {
  const char* key;
  std::vector<double> JointReadings::*values;
  Range range;
};

constexpr std::array<JointList, 6> jointLists{{
    {"measured", &JointReadings::measured, angleRange},
    {"commanded", &JointReadings::commanded, angleRange},
    {"velocity", &JointReadings::velocity, {-100, 100, "rad/s"}},
    {"approach", &JointReadings::approach, {-1, 1, "(-1, 0 or +1)"}},
    {"temperature", &JointReadings::temperature, {-100, 500, "degrees Celsius"}},
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

/// A capture set while it is read. Where refusals are collected, it also knows the ids of what was refused, so that
/// what refers to it is not refused as well.
struct Reading {
  CaptureSet& set;
  Refusals& refusals;
  std::set<std::string> refusedCameras = {}, refusedBoards = {};
  std::set<int> refusedStances = {};
  bool knowsJoints = true, knowsCameras = true, knowsBoards = true, knowsStances = true; // the lists themselves
};

/// Reads one list under `joints`; NaN stands for null, which is valid where `measured` has it too.
std::vector<double> readJointList(const JsonCursor& place, const JointList& list, const JointReadings& joints,
                                  Reading& reading) {
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
    if (std::isnan(values[i]) && isRecorded && place.value()[i].is_null()) {
      reading.refusals.attempt([&] { place.elements()[i].number(list.range); });
    }
  }
  return values;
}

JointReadings readJoints(const JsonCursor& place, Reading& reading) {
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
BoardCorners readBoardCorners(const JsonCursor& place, const CameraIntrinsics* camera, Reading& reading) {
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

std::vector<BoardCorners> readCorners(const JsonCursor& place, const CameraIntrinsics* camera, Reading& reading) {
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

/// Reads an entry of `captures`, checked against the joints, cameras, boards and stances of its set.
Capture readCapture(const JsonCursor& place, Reading& reading) {
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
  const CameraIntrinsics* camera = nullptr;
  refusals.attempt([&] {
    capture.camera = place.at("camera").text();
    const auto named = set.cameras.find(capture.camera);
    camera = named == set.cameras.end() ? nullptr : &named->second;
    if (camera == nullptr && reading.knowsCameras && !reading.refusedCameras.contains(capture.camera)) {
      place.at("camera").refuse("the name of one of the set's `cameras`");
    }
  });
  refusals.attempt(
      [&] { capture.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").wordIndex(supportFootWords)); });
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
  } else if (!image) {
    refusals.attempt([&] { place.refuse("`corners`, or an `image` to find them in", "neither"); });
  }
  return capture;
}

using nlohmann::json;

constexpr std::array<std::string_view, 26> naoJoints{
    "HeadYaw",       "HeadPitch",    "LShoulderPitch", "LShoulderRoll", "LElbowYaw",   "LElbowRoll",  "LWristYaw",
    "LHand",         "LHipYawPitch", "LHipRoll",       "LHipPitch",     "LKneePitch",  "LAnklePitch", "LAnkleRoll",
    "RHipYawPitch",  "RHipRoll",     "RHipPitch",      "RKneePitch",    "RAnklePitch", "RAnkleRoll",  "RShoulderPitch",
    "RShoulderRoll", "RElbowYaw",    "RElbowRoll",     "RWristYaw",     "RHand"};

void requireCaptureSet(const JsonCursor& top) {
  const JsonCursor format = top.at("format");
  if (format.value() != "naocal-captures") {
    format.refuse("\"naocal-captures\", the format of a capture set");
  }
  requireVersion(top);
}

void readRobot(const JsonCursor& place, CaptureSet& set) {
  set.model = place.at("model").text();
  const auto id = [&](const char* key) {
    const auto given = place.find(key);
    return given ? given->text() : std::string{};
  };
  set.bodyId = id("bodyId");
  set.headId = id("headId");
}

std::vector<std::string> readJointNames(const JsonCursor& place, Refusals& refusals) {
  std::vector<std::string> names;
  for (const JsonCursor& entry : place.elements()) {
    std::string name;
    refusals.attempt([&] {
      name = entry.text();
      if (std::find(naoJoints.begin(), naoJoints.end(), name) == naoJoints.end()) {
        entry.refuse("one of the 26 joint names of a NAO, such as LKneePitch");
      }
      if (std::find(names.begin(), names.end(), name) != names.end()) {
        entry.refuse("every joint once");
      }
    });
    names.push_back(name); // also where it was refused: lists of angles have one number for it
  }
  if (names.empty()) {
    place.refuse("at least one joint name");
  }
  return names;
}

CameraIntrinsics readCamera(const JsonCursor& place) {
  CameraIntrinsics camera;
  camera.width = place.at("width").integer(1, 100000);
  camera.height = place.at("height").integer(1, 100000);
  camera.fx = place.at("fx").number({1, 1e6, "px"});
  camera.fy = place.at("fy").number({1, 1e6, "px"});
  camera.cx = place.at("cx").number({-1e5, 1e5, "px"});
  camera.cy = place.at("cy").number({-1e5, 1e5, "px"});
  const auto terms = place.at("distortion").numbers(5, {-1000, 1000, ""}, "k1, k2, p1, p2, k3");
  std::copy(terms.begin(), terms.end(), camera.distortion.begin());
  return camera;
}

void readCameras(const JsonCursor& place, Reading& reading) {
  for (const auto& member : place.members()) {
    if (!reading.refusals.attempt([&] { reading.set.cameras.emplace(member.first, readCamera(member.second)); })) {
      reading.refusedCameras.insert(member.first);
    }
  }
}

Stance readStance(const JsonCursor& place) {
  Stance stance;
  stance.id = place.at("id").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  stance.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").wordIndex(supportFootWords));
  if (const auto placement = place.find("placement")) {
    stance.placement = readFloorPlacement(*placement);
  }
  return stance;
}

/// Reads a list of entries with distinct ids. Where refusals are collected, `refused` receives the ids of the refused.
template <typename Entry, typename Id>
std::vector<Entry> readList(const JsonCursor& place, Entry (*read)(const JsonCursor&), Refusals& refusals,
                            std::set<Id>& refused) {
  std::vector<Entry> entries;
  std::set<Id> ids;
  for (const JsonCursor& element : place.elements()) {
    const bool isRead = refusals.attempt([&] {
      Entry entry = read(element);
      if (!ids.insert(entry.id).second) {
        element.at("id").refuse("an id that no other entry of the list has");
      }
      entries.push_back(std::move(entry));
    });
    if (!isRead && element.value().is_object() && element.value().contains("id")) {
      const json& id = element.value()["id"];
      if constexpr (std::is_same_v<Id, int>) {
        refused.insert(id.is_number_integer() ? id.template get<int>() : 0);
      } else if (id.is_string()) {
        refused.insert(id.template get<Id>());
      }
    }
  }
  return entries;
}

/// The capture's place, described by id and pose for messages.
JsonCursor nameCapture(const JsonCursor& place) {
  const auto id = place.find("id"), pose = place.find("pose");
  std::string name = id && id->value().is_number() ? "capture " + id->value().dump() : "capture without id";
  if (pose && pose->value().is_string()) {
    name += ", pose " + pose->value().dump();
  }
  return place.describeAs(name, "correct it or leave it out with --skip-bad");
}

void requireSupportFootOfStance(const Capture& capture, const CaptureSet& set, const JsonCursor& place) {
  const auto stance = std::find_if(set.stances.begin(), set.stances.end(),
                                   [&](const Stance& candidate) { return candidate.id == capture.stance; });
  if (stance != set.stances.end() && stance->supportFoot != capture.supportFoot) {
    place.at("supportFoot")
        .refuse(fmt::format("\"{}\", as stance {} has it",
                            supportFootWords[static_cast<std::size_t>(stance->supportFoot)], stance->id));
  }
}

/// `skipped`: receives the sentence of each capture that is left out, with BadCapturePolicy::skip.
void readCaptures(const JsonCursor& place, BadCapturePolicy bad, Reading& reading, std::vector<std::string>& skipped) {
  std::set<int> ids;
  for (const JsonCursor& entry : place.elements()) {
    Capture capture;
    try {
      const bool isObject = reading.refusals.attempt([&] { nameCapture(entry); });
      if (!isObject) {
        continue;
      }
      const std::size_t before = reading.refusals.sentences().size();
      capture = readCapture(nameCapture(entry), reading);
      if (reading.refusals.sentences().size() > before) {
        const auto id = entry.value().find("id");
        if (id != entry.value().end() && id->is_number_integer() && !ids.insert(id->get<int>()).second) {
          reading.refusals.attempt([&] { entry.at("id").refuse("an id that no other capture has"); });
        }
        continue; // collected
      }
    } catch (const InputError& error) {
      if (bad == BadCapturePolicy::refuse || !entry.value().is_object()) {
        throw;
      }
      skipped.emplace_back(error.what());
      continue;
    }
    reading.refusals.attempt([&] { requireSupportFootOfStance(capture, reading.set, entry); });
    reading.refusals.attempt([&] {
      if (!ids.insert(capture.id).second) {
        entry.at("id").refuse("an id that no other capture has");
      }
    });
    capture.source = {reading.set.source, &entry.value()};
    reading.set.captures.push_back(std::move(capture));
  }
}

void requireBoundedNumber(const JsonCursor& captures) {
  if (captures.value().size() > mostCaptures) {
    captures.refuse(fmt::format("at most {} captures in a set; split it into several", mostCaptures),
                    fmt::format("{}", captures.value().size()));
  }
}

/// Reads the whole set into `reading.set`, whose `source` is the document.
void readSet(const JsonCursor& top, BadCapturePolicy bad, Reading& reading, std::vector<std::string>& skipped) {
  CaptureSet& set = reading.set;
  Refusals& refusals = reading.refusals;
  requireCaptureSet(top);
  refusals.attempt([&] { readRobot(top.at("robot"), set); });
  reading.knowsJoints = refusals.attempt([&] { set.jointNames = readJointNames(top.at("jointNames"), refusals); });
  reading.knowsCameras = refusals.attempt([&] { readCameras(top.at("cameras"), reading); });
  reading.knowsBoards =
      refusals.attempt([&] { set.boards = readList(top.at("boards"), readBoard, refusals, reading.refusedBoards); });
  if (reading.knowsBoards && set.boards.size() == top.at("boards").value().size()) {
    refusals.attempt([&] { requireDistinctMarkers(set.boards, top.at("boards")); });
  }
  reading.knowsStances = refusals.attempt(
      [&] { set.stances = readList(top.at("stances"), readStance, refusals, reading.refusedStances); });
  refusals.attempt([&] {
    requireBoundedNumber(top.at("captures"));
    readCaptures(top.at("captures"), bad, reading, skipped);
  });
}

using nlohmann::json;

using Written = nlohmann::ordered_json;

Written cameraJson(const CameraIntrinsics& camera, const json& read) {
  return mergeUnknownKeys({{"width", camera.width},
                           {"height", camera.height},
                           {"fx", camera.fx},
                           {"fy", camera.fy},
                           {"cx", camera.cx},
                           {"cy", camera.cy},
                           {"distortion", camera.distortion}},
                          read);
}

Written stanceJson(const Stance& stance, const json& read) {
  const json& placement = childOrNull(read, "placement");
  return mergeUnknownKeys({{"id", stance.id},
                           {"supportFoot", supportFootWords[static_cast<std::size_t>(stance.supportFoot)]},
                           {"placement", stance.placement ? toJson(*stance.placement, true, placement) : Written()}},
                          read);
}

Written setJson(const CaptureSet& set, const json& read) {
  Written cameras = Written::object(), boards = Written::array(), stances = Written::array();
  for (const auto& [name, camera] : set.cameras) {
    cameras[name] = cameraJson(camera, childOrNull(childOrNull(read, "cameras"), name));
  }
  for (const Board& board : set.boards) {
    boards.push_back(toJson(board, entryOrNull("id", board.id, childOrNull(read, "boards"))));
  }
  for (const Stance& stance : set.stances) {
    stances.push_back(stanceJson(stance, entryOrNull("id", stance.id, childOrNull(read, "stances"))));
  }
  const auto unlessEmpty = [](const std::string& text) { return text.empty() ? Written() : Written(text); };
  const Written robot{{"model", set.model}, {"bodyId", unlessEmpty(set.bodyId)}, {"headId", unlessEmpty(set.headId)}};
  return mergeUnknownKeys(
      withFormatInOrder("naocal-captures", {{"robot", mergeUnknownKeys(robot, childOrNull(read, "robot"))},
                                            {"jointNames", set.jointNames},
                                            {"cameras", cameras},
                                            {"boards", boards},
                                            {"stances", stances},
                                            {"captures", Written::array()}}),
      read);
}

/// One line per camera, board, stance and capture: readable, and suitable for line-based diffs.
std::string formatLines(const Written& value) {
  const bool isList = value.is_array();
  std::string text{isList ? '[' : '{'};
  for (const auto& [key, entry] : value.items()) {
    text += text.size() > 1 ? ",\n  " : "\n  ";
    text += (isList ? "" : compactText(key) + ": ") + compactText(entry);
  }
  return text + (text.size() > 1 ? "\n " : "") + (isList ? ']' : '}');
}

using nlohmann::json;

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

/// Formats a capture as an entry of `captures`. `read`: the entry it was read from, or null.
Written captureJson(const Capture& capture, const json& read) {
  Written known{{"id", capture.id},
                {"pose", capture.pose},
                {"repeat", capture.repeat},
                {"repeatKind", repeatKindWords[static_cast<std::size_t>(capture.repeatKind)]},
                {"time", capture.time.count()},
                {"camera", capture.camera},
                {"supportFoot", supportFootWords[static_cast<std::size_t>(capture.supportFoot)]},
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
  return mergeUnknownKeys(known, read);
}

} // namespace

LoadedCaptureSet parseCaptureSet(const std::string& text, const std::string& name, BadCapturePolicy bad) {
  LoadedCaptureSet read;
  read.set.name = name;
  read.set.source = std::make_shared<const json>(parseJson(text, name));
  Refusals refusals;
  Reading reading{read.set, refusals};
  readSet(JsonCursor{*read.set.source, name}, bad, reading, read.skipped);
  return read;
}

SurveyedCaptureSet surveyCaptureSet(const std::string& text, const std::string& name) {
  SurveyedCaptureSet survey;
  survey.set.name = name;
  survey.set.source = std::make_shared<const json>(parseJson(text, name));
  Refusals refusals{Refusals::Treatment::collect};
  Reading reading{survey.set, refusals};
  std::vector<std::string> skipped;
  readSet(JsonCursor{*survey.set.source, name}.recordKeys(survey.asked), BadCapturePolicy::refuse, reading, skipped);
  survey.refusals = refusals.sentences();
  return survey;
}

LoadedCaptureSet readCaptureSet(const std::filesystem::path& folder, BadCapturePolicy bad) {
  const auto file = folder / "captures.json";
  LoadedCaptureSet read = parseCaptureSet(readFile(file), file.string(), bad);
  read.set.name = std::filesystem::canonical(folder).filename().string();
  return read;
}

std::string formatCaptureSet(const CaptureSet& set) {
  const json none;
  Written whole = setJson(set, set.source ? *set.source : none);
  for (const Capture& capture : set.captures) {
    whole["captures"].push_back(captureJson(capture, capture.source ? *capture.source : none));
  }
  std::string text{"{"};
  for (const auto& [key, value] : whole.items()) {
    const bool holdsMany = key == "cameras" || key == "boards" || key == "stances" || key == "captures";
    text += fmt::format("{}\n {}: {}", text.size() > 1 ? "," : "", compactText(key),
                        holdsMany ? formatLines(value) : compactText(value));
  }
  return text + "\n}\n";
}

void writeCaptureSet(const CaptureSet& set, const std::filesystem::path& folder) {
  try {
    createFolders(folder);
  } catch (const std::filesystem::filesystem_error& error) {
    throw InputError{fmt::format("{}: the folder cannot be made: {}; choose another place", folder.string(),
                                 error.code().message())};
  }
  writeAtomically(folder / "captures.json", formatCaptureSet(set));
}

std::filesystem::path pictureFile(const Capture& capture, const std::filesystem::path& folder) {
  const auto file = fileInside(folder, capture.image);
  if (!file) {
    throw InputError{fmt::format("{}: expected a picture within the set's folder, found a path out of it; copy the "
                                 "picture into the set",
                                 (folder / capture.image).string())};
  }
  return *file;
}

} // namespace naocal

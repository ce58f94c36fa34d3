#include "data/CaptureSetFile.hpp"

#include "data/BoardFile.hpp"
#include "data/Capture.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "io/JsonWriter.hpp"

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

JointReadings readJoints(const JsonCursor& place, const CaptureSet& set) {
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
      if (std::isnan(values[i]) && !std::isnan(joints.measured[i])) { // null stands for joints that were not recorded
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

BoardCorners readBoardCorners(const JsonCursor& place, const CaptureSet& set, const CameraIntrinsics& camera) {
  BoardCorners corners;
  corners.board = place.at("board").text();
  const auto board = std::find_if(set.boards.begin(), set.boards.end(),
                                  [&](const Board& candidate) { return candidate.id == corners.board; });
  if (board == set.boards.end()) {
    place.at("board").refuse("the id of one of the set's `boards`");
  }
  std::set<int> seen;
  for (const JsonCursor& id : place.at("ids").elements()) {
    corners.ids.push_back(id.integer(0, static_cast<int>(board->points.size()) - 1));
    if (!seen.insert(corners.ids.back()).second) {
      id.refuse("every corner of a board once per picture");
    }
  }
  const JsonCursor uv = place.at("uv");
  const auto pairs = uv.elements();
  if (pairs.size() != corners.ids.size()) {
    uv.refuse(fmt::format("a list of {} pairs (one per entry of `ids`)", corners.ids.size()));
  }
  for (const JsonCursor& pair : pairs) {
    pair.numbers(2, {-1e9, 1e9, "px"}, "u, v");
    const auto uAndV = pair.elements();
    corners.uv.emplace_back(uAndV[0].number({-imageMargin, camera.width + imageMargin, "px"}),
                            uAndV[1].number({-imageMargin, camera.height + imageMargin, "px"}));
  }
  return corners;
}

std::vector<BoardCorners> readCorners(const JsonCursor& place, const CaptureSet& set, const CameraIntrinsics& camera) {
  std::vector<BoardCorners> corners;
  std::set<std::string> boards;
  for (const JsonCursor& entry : place.elements()) {
    corners.push_back(readBoardCorners(entry, set, camera));
    if (!boards.insert(corners.back().board).second) {
      entry.at("board").refuse("every board once per capture");
    }
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
Capture readCapture(const JsonCursor& place, const CaptureSet& set) {
  Capture capture;
  capture.id = place.at("id").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  capture.pose = place.at("pose").text();
  capture.repeat = place.at("repeat").integer(0, std::numeric_limits<int>::max());
  if (const auto kind = place.find("repeatKind")) {
    capture.repeatKind = static_cast<RepeatKind>(kind->wordIndex(repeatKindWords));
  }
  capture.time = Seconds{place.at("time").number({-1e12, 1e12, "s"})};
  capture.camera = place.at("camera").text();
  const auto camera = set.cameras.find(capture.camera);
  if (camera == set.cameras.end()) {
    place.at("camera").refuse("the name of one of the set's `cameras`");
  }
  capture.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").wordIndex(supportFootWords));
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
    capture.image = readImagePath(*image);
  }
  if (const auto corners = place.find("corners")) {
    capture.corners = readCorners(*corners, set, camera->second);
  } else if (capture.image.empty()) {
    place.refuse("`corners`, or an `image` to find them in", "neither");
  }
  return capture;
}

using nlohmann::json;

constexpr std::array<std::string_view, 26> naoJoints{
    "HeadYaw",       "HeadPitch",    "LShoulderPitch", "LShoulderRoll", "LElbowYaw",   "LElbowRoll",  "LWristYaw",
    "LHand",         "LHipYawPitch", "LHipRoll",       "LHipPitch",     "LKneePitch",  "LAnklePitch", "LAnkleRoll",
    "RHipYawPitch",  "RHipRoll",     "RHipPitch",      "RKneePitch",    "RAnklePitch", "RAnkleRoll",  "RShoulderPitch",
    "RShoulderRoll", "RElbowYaw",    "RElbowRoll",     "RWristYaw",     "RHand"};

void requireFormat(const JsonCursor& top) {
  const JsonCursor format = top.at("format"), version = top.at("version");
  if (format.value() != "naocal-captures") {
    format.refuse("\"naocal-captures\", the format of a capture set");
  }
  if (version.value() != 1) {
    version.refuse("1, the only version that this program reads");
  }
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

std::vector<std::string> readJointNames(const JsonCursor& place) {
  std::vector<std::string> names;
  for (const JsonCursor& entry : place.elements()) {
    const std::string name = entry.text();
    if (std::find(naoJoints.begin(), naoJoints.end(), name) == naoJoints.end()) {
      entry.refuse("one of the 26 joint names of a NAO, such as LKneePitch");
    }
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      entry.refuse("every joint once");
    }
    names.push_back(name);
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

Stance readStance(const JsonCursor& place) {
  Stance stance;
  stance.id = place.at("id").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  stance.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").wordIndex(supportFootWords));
  if (const auto placement = place.find("placement")) {
    stance.placement = readFloorPlacement(*placement);
  }
  return stance;
}

/// Reads a list of entries with distinct ids.
template <typename Entry> std::vector<Entry> readList(const JsonCursor& place, Entry (*read)(const JsonCursor&)) {
  std::vector<Entry> entries;
  for (const JsonCursor& element : place.elements()) {
    Entry entry = read(element);
    if (std::any_of(entries.begin(), entries.end(), [&](const Entry& other) { return other.id == entry.id; })) {
      element.at("id").refuse("an id that no other entry of the list has");
    }
    entries.push_back(std::move(entry));
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
  if (stance->supportFoot != capture.supportFoot) {
    place.at("supportFoot")
        .refuse(fmt::format("\"{}\", as stance {} has it",
                            supportFootWords[static_cast<std::size_t>(stance->supportFoot)], stance->id));
  }
}

void readCaptures(const JsonCursor& place, BadCapturePolicy bad, LoadedCaptureSet& read) {
  std::set<int> ids;
  for (const JsonCursor& entry : place.elements()) {
    Capture capture;
    try {
      capture = readCapture(nameCapture(entry), read.set);
    } catch (const InputError& error) {
      if (bad == BadCapturePolicy::refuse || !entry.value().is_object()) {
        throw;
      }
      read.skipped.emplace_back(error.what());
      continue;
    }
    requireSupportFootOfStance(capture, read.set, entry);
    if (!ids.insert(capture.id).second) {
      entry.at("id").refuse("an id that no other capture has");
    }
    capture.source = {read.set.source, &entry.value()};
    read.set.captures.push_back(std::move(capture));
  }
}

using nlohmann::json;

using Written = nlohmann::ordered_json;

using Written = nlohmann::ordered_json;

Written placementJson(const Placement& placement, bool onFloor, const json& read, bool zeros = true) {
  Written known;
  for (const PlacementKey& key : placementKeys) {
    const double value = placement.*key.value;
    const bool isWritten = (key.onFloor || !onFloor) && (zeros || value != 0);
    known[key.key] = isWritten ? Written(value) : Written();
  }
  return mergeUnknownKeys(known, read);
}

Written sigmaJson(const Placement& sigma, bool onFloor, const json& read) {
  const bool isNumber = sigma.x > 0 && sigma.x == sigma.y && (onFloor || sigma.x == sigma.z) && sigma.roll == 0 &&
                        sigma.pitch == 0 && sigma.yaw == 0 && !read.is_object();
  return isNumber ? Written(sigma.x) : placementJson(sigma, onFloor, read, false);
}

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

Written boardJson(const Board& board, const json& read) {
  const bool onFloor = board.link == "floor";
  Written known{{"id", board.id}, {"link", board.link}};
  const CharucoPattern pattern = board.pattern.value_or(CharucoPattern{});
  const auto ofPattern = [&](auto value) { return board.pattern ? Written(value) : Written(); };
  known["dictionary"] = ofPattern(pattern.dictionary);
  known["squaresX"] = ofPattern(pattern.squaresX);
  known["squaresY"] = ofPattern(pattern.squaresY);
  known["squareLength"] = ofPattern(pattern.squareLength);
  known["markerLength"] = ofPattern(pattern.markerLength);
  known["firstMarkerId"] = ofPattern(pattern.firstMarkerId);
  known["legacyPattern"] = ofPattern(pattern.legacyPattern);
  known["points"] = nullptr;
  if (!board.pattern) {
    for (const Eigen::Vector3d& point : board.points) {
      known["points"].push_back({point.x(), point.y(), point.z()});
    }
  }
  const auto placement = [&](const char* key, const std::optional<Placement>& given) {
    known[key] = given ? placementJson(*given, onFloor, childOrNull(read, key)) : Written();
  };
  placement("placement", board.placement);
  placement("placementGuess", board.hasGuess ? std::optional{board.placementGuess} : std::nullopt);
  known["placementSigma"] =
      board.placementSigma ? sigmaJson(*board.placementSigma, onFloor, childOrNull(read, "placementSigma")) : Written();
  return mergeUnknownKeys(known, read);
}

Written stanceJson(const Stance& stance, const json& read) {
  const json& placement = childOrNull(read, "placement");
  return mergeUnknownKeys(
      {{"id", stance.id},
       {"supportFoot", supportFootWords[static_cast<std::size_t>(stance.supportFoot)]},
       {"placement", stance.placement ? placementJson(*stance.placement, true, placement) : Written()}},
      read);
}

Written setJson(const CaptureSet& set, const json& read) {
  Written cameras = Written::object(), boards = Written::array(), stances = Written::array();
  for (const auto& [name, camera] : set.cameras) {
    cameras[name] = cameraJson(camera, childOrNull(childOrNull(read, "cameras"), name));
  }
  for (const Board& board : set.boards) {
    boards.push_back(boardJson(board, entryOrNull("id", board.id, childOrNull(read, "boards"))));
  }
  for (const Stance& stance : set.stances) {
    stances.push_back(stanceJson(stance, entryOrNull("id", stance.id, childOrNull(read, "stances"))));
  }
  const auto unlessEmpty = [](const std::string& text) { return text.empty() ? Written() : Written(text); };
  const Written robot{{"model", set.model}, {"bodyId", unlessEmpty(set.bodyId)}, {"headId", unlessEmpty(set.headId)}};
  return mergeUnknownKeys({{"format", "naocal-captures"},
                           {"version", 1},
                           {"robot", mergeUnknownKeys(robot, childOrNull(read, "robot"))},
                           {"jointNames", set.jointNames},
                           {"cameras", cameras},
                           {"boards", boards},
                           {"stances", stances},
                           {"captures", Written::array()}},
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
  Written known;
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
  CaptureSet& set = read.set;
  set.name = name;
  set.source = std::make_shared<const json>(parseJson(text, name));
  const JsonCursor top{*set.source, name};
  requireFormat(top);
  readRobot(top.at("robot"), set);
  set.jointNames = readJointNames(top.at("jointNames"));
  for (const auto& [camera, place] : top.at("cameras").members()) {
    set.cameras.emplace(camera, readCamera(place));
  }
  set.boards = readList(top.at("boards"), readBoard);
  requireDistinctMarkers(set.boards, top.at("boards"));
  set.stances = readList(top.at("stances"), readStance);
  const JsonCursor captures = top.at("captures");
  if (captures.value().size() > mostCaptures) {
    captures.refuse(fmt::format("at most {} captures in a set; split it into several", mostCaptures),
                    fmt::format("{}", captures.value().size()));
  }
  readCaptures(captures, bad, read);
  return read;
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
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError{
        fmt::format("{}: the folder cannot be made: {}; choose another place", folder.string(), error.message())};
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

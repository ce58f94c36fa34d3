#include "captures/BoardReader.hpp"
#include "captures/CaptureReader.hpp"
#include "captures/CaptureSetFile.hpp"
#include "captures/CaptureWords.hpp"
#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "captures/JsonText.hpp"
#include "captures/PatternReader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 26> naoJoints{
    "HeadYaw",       "HeadPitch",    "LShoulderPitch", "LShoulderRoll", "LElbowYaw",   "LElbowRoll",  "LWristYaw",
    "LHand",         "LHipYawPitch", "LHipRoll",       "LHipPitch",     "LKneePitch",  "LAnklePitch", "LAnkleRoll",
    "RHipYawPitch",  "RHipRoll",     "RHipPitch",      "RKneePitch",    "RAnklePitch", "RAnkleRoll",  "RShoulderPitch",
    "RShoulderRoll", "RElbowYaw",    "RElbowRoll",     "RWristYaw",     "RHand"};

void requireFormat(const JsonPlace& top) {
  const JsonPlace format = top.at("format"), version = top.at("version");
  if (format.value() != "naocal-captures") {
    format.refuse("\"naocal-captures\", the format of a capture set");
  }
  if (version.value() != 1) {
    version.refuse("1, the only version that this program reads");
  }
}

void readRobot(const JsonPlace& place, CaptureSet& set) {
  set.model = place.at("model").text();
  const auto id = [&](const char* key) {
    const auto given = place.find(key);
    return given ? given->text() : std::string{};
  };
  set.bodyId = id("bodyId");
  set.headId = id("headId");
}

std::vector<std::string> readJointNames(const JsonPlace& place) {
  std::vector<std::string> names;
  for (const JsonPlace& entry : place.elements()) {
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

CameraIntrinsics readCamera(const JsonPlace& place) {
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

Stance readStance(const JsonPlace& place) {
  Stance stance;
  stance.id = place.at("id").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  stance.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").oneOf(supportFootWords));
  if (const auto placement = place.find("placement")) {
    stance.placement = readFloorPlacement(*placement);
  }
  return stance;
}

/// The entries of a list, whose ids must differ.
template <typename Entry> std::vector<Entry> readList(const JsonPlace& place, Entry (*read)(const JsonPlace&)) {
  std::vector<Entry> entries;
  for (const JsonPlace& element : place.elements()) {
    Entry entry = read(element);
    if (std::any_of(entries.begin(), entries.end(), [&](const Entry& other) { return other.id == entry.id; })) {
      element.at("id").refuse("an id that no other entry of the list has");
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// A capture's place with the name it is refused by.
JsonPlace named(const JsonPlace& place) {
  const auto id = place.find("id"), pose = place.find("pose");
  std::string name = id && id->value().is_number() ? "capture " + id->value().dump() : "capture without id";
  if (pose && pose->value().is_string()) {
    name += ", pose " + pose->value().dump();
  }
  return place.about(name, "correct it or leave it out with --skip-bad");
}

void requireSupportFootOfStance(const Capture& capture, const CaptureSet& set, const JsonPlace& place) {
  const auto stance = std::find_if(set.stances.begin(), set.stances.end(),
                                   [&](const Stance& candidate) { return candidate.id == capture.stance; });
  if (stance->supportFoot != capture.supportFoot) {
    place.at("supportFoot")
        .refuse(fmt::format("\"{}\", as stance {} has it",
                            supportFootWords[static_cast<std::size_t>(stance->supportFoot)], stance->id));
  }
}

void readCaptures(const JsonPlace& place, BadCaptures bad, ReadCaptureSet& read) {
  std::set<int> ids;
  for (const JsonPlace& entry : place.elements()) {
    Capture capture;
    try {
      capture = readCapture(named(entry), read.set);
    } catch (const InputError& error) {
      if (bad == BadCaptures::refuse || !entry.value().is_object()) {
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

} // namespace

ReadCaptureSet parseCaptureSet(const std::string& text, const std::string& name, BadCaptures bad) {
  ReadCaptureSet read;
  CaptureSet& set = read.set;
  set.name = name;
  set.source = std::make_shared<const json>(parseJson(text, name));
  const JsonPlace top{*set.source, name};
  requireFormat(top);
  readRobot(top.at("robot"), set);
  set.jointNames = readJointNames(top.at("jointNames"));
  for (const auto& [camera, place] : top.at("cameras").members()) {
    set.cameras.emplace(camera, readCamera(place));
  }
  set.boards = readList(top.at("boards"), readBoard);
  requireDistinctMarkers(set.boards, top.at("boards"));
  set.stances = readList(top.at("stances"), readStance);
  readCaptures(top.at("captures"), bad, read);
  return read;
}

ReadCaptureSet readCaptureSet(const std::filesystem::path& folder, BadCaptures bad) {
  const auto file = folder / "captures.json";
  ReadCaptureSet read = parseCaptureSet(fileContent(file), file.string(), bad);
  read.set.name = std::filesystem::canonical(folder).filename().string();
  return read;
}

} // namespace naocal

#include "data/CaptureSetFile.hpp"

#include "data/BoardFile.hpp"
#include "data/CaptureFile.hpp"
#include "data/InstrumentFile.hpp"
#include "data/SceneFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/Folders.hpp"
#include "io/InputError.hpp"
#include "io/JsonWriter.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using nlohmann::json;
using Written = nlohmann::ordered_json;

constexpr int newestVersion = 2;

constexpr std::array<std::string_view, 26> naoJoints{
    "HeadYaw",       "HeadPitch",    "LShoulderPitch", "LShoulderRoll", "LElbowYaw",   "LElbowRoll",  "LWristYaw",
    "LHand",         "LHipYawPitch", "LHipRoll",       "LHipPitch",     "LKneePitch",  "LAnklePitch", "LAnkleRoll",
    "RHipYawPitch",  "RHipRoll",     "RHipPitch",      "RKneePitch",    "RAnklePitch", "RAnkleRoll",  "RShoulderPitch",
    "RShoulderRoll", "RElbowYaw",    "RElbowRoll",     "RWristYaw",     "RHand"};

/// Returns the version.
int requireCaptureSet(const JsonCursor& top) {
  const JsonCursor format = top.at("format");
  if (format.value() != "naocal-captures") {
    format.refuse("\"naocal-captures\", the format of a capture set");
  }
  requireVersion(top, newestVersion);
  return top.at("version").integer(1, newestVersion);
}

std::string readUrdfPath(const JsonCursor& place) {
  const std::filesystem::path file = place.text();
  if (file.is_absolute() || std::find(file.begin(), file.end(), "..") != file.end()) {
    place.refuse("a path inside the set's folder, such as robot.urdf");
  }
  return file.string();
}

void readRobot(const JsonCursor& place, CaptureSet& set) {
  const auto textOf = [&](const char* key) {
    const auto given = place.find(key);
    return given ? given->text() : std::string{};
  };
  const auto urdf = set.version > 1 ? place.find("urdf") : std::nullopt;
  if (urdf && place.find("model")) {
    place.refuse("either `urdf` or `model`", "both");
  }
  if (urdf) {
    set.model.clear();
    set.urdf = readUrdfPath(*urdf);
    set.base = textOf("base");
    set.bodyId = textOf("id");
    return;
  }
  set.model = place.at("model").text();
  set.bodyId = textOf("bodyId");
  set.headId = textOf("headId");
}

/// `isNao`: only the joints of a NAO are known; the description of another robot knows its own.
std::vector<std::string> readJointNames(const JsonCursor& place, bool isNao, Refusals& refusals) {
  std::vector<std::string> names;
  for (const JsonCursor& entry : place.elements()) {
    std::string name;
    refusals.attempt([&] {
      name = entry.text();
      if (isNao && std::find(naoJoints.begin(), naoJoints.end(), name) == naoJoints.end()) {
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
void readCaptures(const JsonCursor& place, BadCapturePolicy bad, SetReading& reading,
                  std::vector<std::string>& skipped) {
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
void readSet(const JsonCursor& top, BadCapturePolicy bad, SetReading& reading, std::vector<std::string>& skipped) {
  CaptureSet& set = reading.set;
  Refusals& refusals = reading.refusals;
  set.version = requireCaptureSet(top);
  refusals.attempt([&] { readRobot(top.at("robot"), set); });
  const bool isModel = set.urdf.empty(), isNao = isModel && set.model.starts_with('V'); // V4, V5, V6
  reading.knowsJoints =
      refusals.attempt([&] { set.jointNames = readJointNames(top.at("jointNames"), isNao, refusals); });
  const auto isThere = [&](const char* key) { return set.version == 1 || top.find(key); }; // pictures are optional
  if (isThere("cameras")) {
    reading.knowsCameras = refusals.attempt([&] { readCameras(top.at("cameras"), reading); });
  }
  if (isThere("boards")) {
    reading.knowsBoards = refusals.attempt(
        [&] { set.boards = readEntries<Board>(top.at("boards"), readBoard, refusals, reading.refusedBoards); });
    if (reading.knowsBoards && set.boards.size() == top.at("boards").value().size()) {
      refusals.attempt([&] { requireDistinctMarkers(set.boards, top.at("boards")); });
    }
  }
  if (set.version > 1) {
    readScene(top, reading);
    readInstruments(top, reading);
  }
  reading.knowsStances = refusals.attempt([&] {
    const auto read = [&](const JsonCursor& place) { return readStance(place, isModel); };
    set.stances = readEntries<Stance>(top.at("stances"), read, refusals, reading.refusedStances);
  });
  refusals.attempt([&] {
    requireBoundedNumber(top.at("captures"));
    readCaptures(top.at("captures"), bad, reading, skipped);
  });
}

Written setJson(const CaptureSet& set, const json& read) {
  const bool isModel = set.urdf.empty();
  Written boards = Written::array(), stances = Written::array();
  for (const Board& board : set.boards) {
    boards.push_back(toJson(board, entryOrNull("id", board.id, childOrNull(read, "boards"))));
  }
  for (const Stance& stance : set.stances) {
    stances.push_back(stanceJson(stance, isModel, entryOrNull("id", stance.id, childOrNull(read, "stances"))));
  }
  const auto unlessEmpty = [](const std::string& text) { return text.empty() ? Written() : Written(text); };
  const Written robot =
      isModel ? Written{{"model", set.model}, {"bodyId", unlessEmpty(set.bodyId)}, {"headId", unlessEmpty(set.headId)}}
              : Written{{"urdf", set.urdf}, {"base", unlessEmpty(set.base)}, {"id", unlessEmpty(set.bodyId)}};
  Written known{{"robot", mergeUnknownKeys(robot, childOrNull(read, "robot"))},
                {"jointNames", set.jointNames},
                {"cameras", camerasJson(set, childOrNull(read, "cameras"))},
                {"boards", boards}};
  known.update(instrumentsJson(set.instruments, read));
  known.update(sceneJson(set, read));
  known.update(Written{{"stances", stances}, {"captures", Written::array()}});
  return mergeUnknownKeys(withFormatInOrder("naocal-captures", known, set.version), read);
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

} // namespace

LoadedCaptureSet parseCaptureSet(const std::string& text, const std::string& name, BadCapturePolicy bad) {
  LoadedCaptureSet read;
  read.set.name = name;
  read.set.source = std::make_shared<const json>(parseJson(text, name));
  Refusals refusals;
  SetReading reading{read.set, refusals};
  readSet(JsonCursor{*read.set.source, name}, bad, reading, read.skipped);
  return read;
}

SurveyedCaptureSet surveyCaptureSet(const std::string& text, const std::string& name) {
  SurveyedCaptureSet survey;
  survey.set.name = name;
  survey.set.source = std::make_shared<const json>(parseJson(text, name));
  Refusals refusals{Refusals::Treatment::collect};
  SetReading reading{survey.set, refusals};
  std::vector<std::string> skipped;
  readSet(JsonCursor{*survey.set.source, name}.recordKeys(survey.asked), BadCapturePolicy::refuse, reading, skipped);
  survey.refusals = refusals.sentences();
  return survey;
}

LoadedCaptureSet readCaptureSet(const std::filesystem::path& folder, BadCapturePolicy bad) {
  const auto file = folder / "captures.json";
  LoadedCaptureSet read = parseCaptureSet(readFile(file), file.string(), bad);
  read.set.name = std::filesystem::canonical(folder).filename().string();
  read.set.folder = folder;
  return read;
}

std::string formatCaptureSet(const CaptureSet& set) {
  const json none;
  Written whole = setJson(set, set.source ? *set.source : none);
  for (const Capture& capture : set.captures) {
    whole["captures"].push_back(captureJson(capture, set.urdf.empty(), capture.source ? *capture.source : none));
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

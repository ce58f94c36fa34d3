#include "captures/CaptureSetFile.hpp"
#include "captures/CaptureWords.hpp"
#include "captures/CaptureWriter.hpp"
#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "captures/WrittenJson.hpp"

#include <fmt/format.h>

namespace naocal {
namespace {

using nlohmann::json;
using Written = nlohmann::ordered_json;

Written placementJson(const Placement& placement, bool onFloor, const json& read, bool zeros = true) {
  Written known;
  for (const PlacementKey& key : placementKeys) {
    const double value = placement.*key.value;
    const bool isWritten = (key.onFloor || !onFloor) && (zeros || value != 0);
    known[key.key] = isWritten ? Written(value) : Written();
  }
  return finished(known, read);
}

Written sigmaJson(const Placement& sigma, bool onFloor, const json& read) {
  const bool isNumber = sigma.x > 0 && sigma.x == sigma.y && (onFloor || sigma.x == sigma.z) && sigma.roll == 0 &&
                        sigma.pitch == 0 && sigma.yaw == 0 && !read.is_object();
  return isNumber ? Written(sigma.x) : placementJson(sigma, onFloor, read, false);
}

Written cameraJson(const CameraIntrinsics& camera, const json& read) {
  return finished({{"width", camera.width},
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
    known[key] = given ? placementJson(*given, onFloor, child(read, key)) : Written();
  };
  placement("placement", board.placement);
  placement("placementGuess", board.hasGuess ? std::optional{board.placementGuess} : std::nullopt);
  known["placementSigma"] =
      board.placementSigma ? sigmaJson(*board.placementSigma, onFloor, child(read, "placementSigma")) : Written();
  return finished(known, read);
}

Written stanceJson(const Stance& stance, const json& read) {
  const json& placement = child(read, "placement");
  return finished({{"id", stance.id},
                   {"supportFoot", supportFootWords[static_cast<std::size_t>(stance.supportFoot)]},
                   {"placement", stance.placement ? placementJson(*stance.placement, true, placement) : Written()}},
                  read);
}

Written setJson(const CaptureSet& set, const json& read) {
  Written cameras = Written::object(), boards = Written::array(), stances = Written::array();
  for (const auto& [name, camera] : set.cameras) {
    cameras[name] = cameraJson(camera, child(child(read, "cameras"), name));
  }
  for (const Board& board : set.boards) {
    boards.push_back(boardJson(board, entryWith("id", board.id, child(read, "boards"))));
  }
  for (const Stance& stance : set.stances) {
    stances.push_back(stanceJson(stance, entryWith("id", stance.id, child(read, "stances"))));
  }
  const auto unlessEmpty = [](const std::string& text) { return text.empty() ? Written() : Written(text); };
  const Written robot{{"model", set.model}, {"bodyId", unlessEmpty(set.bodyId)}, {"headId", unlessEmpty(set.headId)}};
  return finished({{"format", "naocal-captures"},
                   {"version", 1},
                   {"robot", finished(robot, child(read, "robot"))},
                   {"jointNames", set.jointNames},
                   {"cameras", cameras},
                   {"boards", boards},
                   {"stances", stances},
                   {"captures", Written::array()}},
                  read);
}

/// One line per camera, board, stance and capture: a person can read it and a version control compare it.
std::string lines(const Written& value) {
  const bool isList = value.is_array();
  std::string text{isList ? '[' : '{'};
  for (const auto& [key, entry] : value.items()) {
    text += text.size() > 1 ? ",\n  " : "\n  ";
    text += (isList ? "" : dumped(key) + ": ") + dumped(entry);
  }
  return text + (text.size() > 1 ? "\n " : "") + (isList ? ']' : '}');
}

} // namespace

std::string captureSetText(const CaptureSet& set) {
  const json none;
  Written whole = setJson(set, set.source ? *set.source : none);
  for (const Capture& capture : set.captures) {
    whole["captures"].push_back(captureJson(capture, capture.source ? *capture.source : none));
  }
  std::string text{"{"};
  for (const auto& [key, value] : whole.items()) {
    const bool holdsMany = key == "cameras" || key == "boards" || key == "stances" || key == "captures";
    text +=
        fmt::format("{}\n {}: {}", text.size() > 1 ? "," : "", dumped(key), holdsMany ? lines(value) : dumped(value));
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
  writeAtomically(folder / "captures.json", captureSetText(set));
}

} // namespace naocal

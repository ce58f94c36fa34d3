#include "console/HeadExport.hpp"

#include "console/print/PrintText.hpp"

#include "calibration/result/Plausibility.hpp"
#include "data/CaptureSetFile.hpp"
#include "dialects/ModelCalibration.hpp"
#include "effects/Catalogue.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "math/Angles.hpp"
#include "robot/RobotOfSet.hpp"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

struct Found {
  RobotCalibration calibration;
  std::vector<std::string> unlearned;  // offsets and directions of cameras that the captures do not tell
  std::vector<std::string> otherTerms; // effects that are neither an offset nor the direction of a camera
  std::string set;                     // folder of the captures
};

std::optional<Eigen::Vector3d> valuesOf(const StoredResult& result, const std::string& term,
                                        const std::array<const char*, 3>& unknowns) {
  Eigen::Vector3d vector;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto found = result.values.find(fmt::format("{}.{}", term, unknowns[i]));
    if (found == result.values.end()) {
      return std::nullopt;
    }
    vector[static_cast<Eigen::Index>(i)] = found->second;
  }
  return vector;
}

/// What is learned; of a camera's rotation one angle suffices, as the others may be traded against the neck's offset.
Found fromTerms(const StoredResult& result) {
  Found found;
  for (const std::string& term : result.terms) {
    const std::string effect = term.substr(0, term.find('@')), place = term.substr(term.find('@') + 1);
    if (effect == effectName::jointOffset) {
      if (isLearned(result, term + ".o")) {
        found.calibration.offsets[place] = result.values.at(term + ".o");
      } else {
        found.unlearned.push_back("the offset of " + place);
      }
    } else if (effect == effectName::cameraRotation) {
      if (isLearned(result, term + ".rx") || isLearned(result, term + ".ry") || isLearned(result, term + ".rz")) {
        found.calibration.cameras[place].rotation = valuesOf(result, term, {"rx", "ry", "rz"});
      } else {
        found.unlearned.push_back("the rotation of camera " + place);
      }
    } else if (effect == effectName::cameraTranslation) {
      found.calibration.cameras[place].translation = valuesOf(result, term, {"x", "y", "z"});
    } else if (!term.starts_with("board")) {
      found.otherTerms.push_back(term);
    }
  }
  return found;
}

Found readFound(const std::string& file, const PostureOptions& options) {
  const nlohmann::json document = parseJson(readFile(file), file);
  Found found;
  std::vector<std::string> folders = options.sets;
  if (document.is_object() && document.value("format", nlohmann::json{}) == "naocal-calibration") {
    found.calibration = parseCalibration(document, file);
    requireNoReasons(file, listImplausible(valuesFromCalibration(found.calibration, {})), options.force);
  } else {
    const StoredResult result = parseResult(document, file);
    requireNoReasons(file, listReasonsAgainstUse(result), options.force);
    found = fromTerms(result);
    folders = findCaptureFolders(result, file, options);
  }
  if (folders.empty()) {
    throw InputError{fmt::format("{}: expected its captures, which hold the robot and the camera's mount, found none "
                                 "where they were; name their folder with --set",
                                 file)};
  }
  found.set = folders.front();
  return found;
}

Robot robotOf(const std::string& folder) {
  return loadRobot(readCaptureSet(folder, BadCapturePolicy::skip).set);
}

/// What of the calibration the file has no place for.
std::vector<std::string> homeless(const HeadDialect& dialect, const Found& found, const HeadCamera& head) {
  std::vector<std::string> words, joints;
  for (const auto& [joint, offset] : found.calibration.offsets) {
    const bool isWritten = joint == head.neckJoint || (dialect.hasBase && head.base && joint == head.base->name);
    if (offset != 0 && !isWritten) {
      joints.push_back(joint);
    }
  }
  if (!joints.empty()) {
    words.push_back(fmt::format("the offsets of {}", fmt::join(joints, ", ")));
  }
  const auto camera = found.calibration.cameras.find(head.name);
  if (camera != found.calibration.cameras.end() && camera->second.translation) {
    words.push_back("the shift of camera " + head.name);
  }
  words.insert(words.end(), found.otherTerms.begin(), found.otherTerms.end());
  return words;
}

} // namespace

void exportHead(const HeadDialect& dialect, const std::string& resultFile, const PostureOptions& options,
                const std::string& camera, const std::string& file) {
  const Found found = readFound(resultFile, options);
  const Robot robot = robotOf(found.set);
  const HeadCamera head = describeHeadCamera(robot, camera, found.calibration);
  const bool hasBase = dialect.hasBase && head.base && head.base->offset;
  if (!head.calibrated && !hasBase) {
    throw InputError{fmt::format("{}: expected a direction of camera {} that is learned, found none: neither its "
                                 "rotation nor the offset of {} is",
                                 resultFile, head.name, head.neckJoint)};
  }
  if (!std::filesystem::is_regular_file(file)) {
    throw InputError{fmt::format("--output: expected the file of {} to change ({}), found none at {}", dialect.name,
                                 dialect.what, file)};
  }
  const std::string before = readFile(file), text = dialect.write(before, file, robot, head);
  writeAtomically(file, text);
  if (head.neckOffset != 0) {
    printText("the direction of camera {} includes the offset of {} ({:.4f}°)\n", head.name, head.neckJoint,
              degrees(head.neckOffset));
  }
  if (!found.unlearned.empty()) {
    printText("left as they are in the file, less than 50 % learned: {}\n",
              fmt::format("{}", fmt::join(found.unlearned, ", ")));
  }
  const std::vector<std::string> words = homeless(dialect, found, head);
  if (!words.empty()) {
    printText("{} has no place for: {}\n", dialect.name, fmt::format("{}", fmt::join(words, "; ")));
  }
  printText("written: {}\n", file);
}

ParsedCalibration importHead(const HeadDialect& dialect, const std::string& file, const std::string& set,
                             const std::string& camera) {
  const Robot robot = robotOf(set);
  const HeadCamera head = describeHeadCamera(robot, camera, {});
  HeadDirection direction = dialect.parse(readFile(file), file, robot, head);
  ParsedCalibration parsed{calibrationFromDirection(head, direction.neckFromCamera, direction.baseOffset),
                           std::move(direction.unused)};
  parsed.calibration.robot = robot.model.empty() ? "URDF" : robot.model;
  return parsed;
}

} // namespace naocal

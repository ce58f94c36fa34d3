#include "console/RobotCalibrationFile.hpp"

#include "console/CommandLine.hpp"
#include "console/print/PrintText.hpp"

#include "calibration/Prediction.hpp"
#include "calibration/result/Plausibility.hpp"
#include "command-line/OptionChecks.hpp"
#include "data/CaptureSetFile.hpp"
#include "data/SetSearch.hpp"
#include "dialects/ModelCalibration.hpp"
#include "effects/Catalogue.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "math/Angles.hpp"
#include "poses/PoseFile.hpp"
#include "poses/candidates/SupportLegs.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

std::vector<std::string> findCaptureFolders(const StoredResult& result, const std::string& file,
                                            const PostureOptions& options) {
  if (!options.sets.empty()) {
    return options.sets;
  }
  const SetSearch search{file, {options.lookIn.begin(), options.lookIn.end()}};
  std::vector<std::string> folders;
  for (std::size_t i = 0; i < result.inputs.sets.size(); ++i) {
    const SoughtSet sought = i < result.inputs.sha256.size() && !result.inputs.sha256[i].empty()
                                 ? findSet({result.inputs.sets[i], result.inputs.sha256[i]}, search)
                                 : SoughtSet{};
    if (!sought.folder) {
      return {};
    }
    if (!sought.sentence.empty()) {
      printText(stderr, "{}\n", sought.sentence);
    }
    folders.push_back(sought.folder->string());
  }
  return folders;
}

bool isLearned(const StoredResult& result, const std::string& unknown) {
  const auto found = result.learned.find(unknown);
  return found == result.learned.end() || isLearned({.learned = found->second});
}

void requireNoReasons(const std::string& file, const std::vector<std::string>& reasons, bool force) {
  if (!reasons.empty() && !force) {
    throw RefusedCalibration{file, reasons};
  }
  for (const std::string& reason : reasons) {
    printText(stderr, "{}: written by force: {}\n", file, reason);
  }
}

int writeUnlessRefused(const std::function<void()>& write) {
  try {
    write();
    return 0;
  } catch (const RefusedCalibration& refused) {
    for (const std::string& reason : refused.reasons) {
      printText(stderr, "{}: not written: {}\n", refused.file, reason);
    }
    return 3;
  }
}

namespace {

constexpr double noticeable = 1e-6; // [rad], of a correction that is shown

const std::array lensEffects{"focalLength", "principalPoint", "radialDistortion", "tangentialDistortion"};

std::string effectOf(const std::string& term) {
  return term.substr(0, term.find('@'));
}

bool isLensTerm(const std::string& term) {
  return std::find(lensEffects.begin(), lensEffects.end(), effectOf(term)) != lensEffects.end();
}

/// Whether the term may correct a joint's angle beside its offset.
bool bendsJoints(const std::string& term) {
  if (effectOf(term) == effectName::jointOffset) {
    return false;
  }
  for (const Effect& effect : allEffects()) {
    if (effect.name == effectOf(term)) {
      return effect.placeKind == PlaceKind::motor || effect.placeKind == PlaceKind::joint ||
             effect.placeKind == PlaceKind::all;
    }
  }
  return true; // an own effect
}

std::vector<CaptureSet> readSets(const std::vector<std::string>& folders) {
  std::vector<CaptureSet> sets;
  for (const std::string& folder : folders) {
    sets.push_back(readCaptureSet(folder, BadCapturePolicy::skip).set);
  }
  return sets;
}

/// Constants from the result's captures, and the lenses that they were taken with.
void evaluate(const std::vector<CaptureSet>& sets, const PostureOptions& options, LoadedCalibration& loaded) {
  const Measurements measurements = buildMeasurements(sets, loaded.robot);
  if (measurements.cornerCount == 0) {
    throw InputError{fmt::format("{}: expected captures with corners, found none", sets.front().name)};
  }
  const Eigen::VectorXd posture =
      options.pose.empty() ? bentKneesStance(loaded.robot) : readAnglesFile(options.pose, loaded.robot);
  const Prediction prediction = preparePrediction(loaded.result, measurements, false);
  loaded.joints = jointCompensations(measurements, prediction.model, prediction.unknowns, posture);
  loaded.calibration = calibrationFromValues(loaded.result.values, sets.front().cameras);
  loaded.calibration.headId = sets.front().headId;
  loaded.calibration.bodyId = sets.front().bodyId;
}

LoadedCalibration fromResult(const nlohmann::json& document, const std::string& file, const PostureOptions& options) {
  LoadedCalibration loaded;
  loaded.result = parseResult(document, file);
  requireNoReasons(file, listReasonsAgainstUse(loaded.result), options.force);
  loaded.robot = loadRobot(configurationDirectory(), loaded.result.robot);
  loaded.folders = findCaptureFolders(loaded.result, file, options);
  const std::vector<CaptureSet> sets = readSets(loaded.folders);
  const auto& terms = loaded.result.terms;
  if (!sets.empty()) {
    evaluate(sets, options, loaded);
  } else if (const auto needs = std::find_if(terms.begin(), terms.end(), bendsJoints); needs != terms.end()) {
    throw InputError{
        fmt::format("{}: its model has {}, whose share at the standing pose follows from the captures, but "
                    "{} is not there as it was; name its folder with --set, or one to search with --look-in",
                    file, *needs, loaded.result.inputs.sets.empty() ? "no set" : loaded.result.inputs.sets.front())};
  } else {
    loaded.calibration = calibrationFromValues(loaded.result.values, {});
  }
  for (const JointCompensation& joint : loaded.joints) {
    loaded.calibration.offsets[joint.joint] = joint.constant();
  }
  std::erase_if(loaded.calibration.offsets, [&](const auto& offset) {
    const bool leftOut = !isLearned(loaded.result, fmt::format("jointOffset@{}.o", offset.first));
    if (leftOut) {
      loaded.unlearned.push_back(offset.first);
    }
    return leftOut;
  });
  for (const std::string& term : terms) {
    const std::string effect = effectOf(term);
    loaded.lensIsEstimated |= isLensTerm(term);
    if (effect != effectName::jointOffset && effect != effectName::cameraRotation && effect != "cameraTranslation" &&
        !isLensTerm(term) && !term.starts_with("board")) {
      loaded.otherTerms.push_back(term);
    }
  }
  return loaded;
}

} // namespace

void addPostureOptions(CLI::App& command, PostureOptions& options) {
  command
      .add_option("--at", options.pose,
                  "a .pose file: the posture at which the constants are right; default: standing, knees bent by 50 "
                  "degrees")
      ->type_name("FILE");
  command.add_option("--set", options.sets, "folder of the captures, where it is no longer as the result names it")
      ->type_name("FOLDER")
      ->group(expertOptions);
  addLookIn(command, options.lookIn);
  command.add_flag("--force", options.force,
                   "write although the result should not be used, or has values that no robot has");
}

LoadedCalibration loadCalibration(const std::string& file, const PostureOptions& options) {
  const nlohmann::json document = parseJson(readFile(file), file);
  if (document.is_object() && document.value("format", nlohmann::json{}) == "naocal-calibration") {
    LoadedCalibration loaded;
    loaded.calibration = parseCalibration(document, file);
    if (!loaded.calibration.robot.empty()) {
      throw InputError{fmt::format("{}: expected the calibration of a NAO, found one of another robot ({})", file,
                                   loaded.calibration.robot)};
    }
    requireNoReasons(file, listImplausible(valuesFromCalibration(loaded.calibration, {})), options.force);
    loaded.robot = loadRobot(configurationDirectory(), "V6");
    return loaded;
  }
  return fromResult(document, file, options);
}

void printCompensations(const LoadedCalibration& loaded) {
  std::vector<JointCompensation> bent = loaded.joints;
  std::erase_if(bent, [](const JointCompensation& joint) {
    return std::max(std::abs(joint.delta), joint.highest - joint.lowest) < noticeable;
  });
  if (!bent.empty()) {
    const auto shown = [](double angle) { return std::round(1000 * degrees(angle)) / 1000 + 0.0; }; // no "-0.000"
    printText("the model corrects these joints beside their offsets [degrees]:\n"
              "  {:<16} {:>9} {:>14} {:>22} {:>16} {:>10}\n",
              "", "offset o", "delta there", "in the captures", "spread (sigma)", "o - delta");
    for (const JointCompensation& joint : bent) {
      printText("  {:<16} {:>9.3f} {:>14.3f} {:>10.3f} to {:>8.3f} {:>16.3f} {:>10.3f}\n", joint.joint,
                shown(joint.offset), shown(joint.delta), shown(joint.lowest), shown(joint.highest), shown(joint.spread),
                shown(joint.constant()));
    }
    printText("a constant is right at the posture only; elsewhere it is off by as much as delta changes\n");
  }
  if (!loaded.otherTerms.empty()) {
    printText("a constant cannot correct: {}\n", fmt::join(loaded.otherTerms, ", "));
  }
  if (!loaded.unlearned.empty()) {
    printText("left out, less than 50 % learned: {}\n", fmt::join(loaded.unlearned, ", "));
  }
}

nlohmann::json compensationsJson(const LoadedCalibration& loaded) {
  nlohmann::json all = nlohmann::json::object();
  for (const JointCompensation& joint : loaded.joints) {
    all[joint.joint] = {{"offset", joint.offset},
                        {"delta", joint.delta},
                        {"deltaMean", joint.mean},
                        {"deltaSpread", joint.spread},
                        {"deltaRange", {joint.lowest, joint.highest}},
                        {"constant", joint.constant()}};
  }
  return all;
}

} // namespace naocal

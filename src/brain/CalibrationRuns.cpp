#include "brain/CalibrationRuns.hpp"

#include "brain/CalibrationInputs.hpp"
#include "dialects/SavedCalibration.hpp"
#include "io/Files.hpp"
#include "io/JsonReader.hpp"
#include "runs/RobotHistory.hpp"
#include "runs/RunFile.hpp"
#include "runs/RunFolder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// Whether a calibration of this kind takes over offsets of the neck only (`headOffsets`): on both feet, others stand
/// for errors of the stance.
bool isHeadOnly(const std::string& kind) {
  const CalibrationKind* known = findCalibrationKind(kind);
  return known != nullptr && known->feet.front() == SupportFoot::both;
}

} // namespace

void to_json(nlohmann::json& out, const PublishedRuns& published) {
  out = nlohmann::json::array();
  for (const Run& run : published.runs) {
    out.push_back({{"id", run.id}, {"run", runJson(run)}});
  }
}

void CalibrationRuns::recordCalibration(const Calibration& calibration) {
  record([&] {
    Run run = begin(calibration.kind);
    run.outcome = calibration.outcome;
    run.errorBefore = calibration.error.before;
    run.errorAfter = calibration.error.after;
    run.heldOut = true;
    const std::filesystem::path folder = std::filesystem::absolute(calibration.folder), solved = folder / "first";
    const std::string result = (solved / "result.json").string();
    run.captures = folder.string();
    run.result = result;
    run.sha256 = sha256(readFile(solved / "captures.json"));
    run.offsets = offsetsOfResult(parseJson(readFile(result), result), result);
    if (isHeadOnly(calibration.kind)) {
      std::erase_if(run.offsets, [](const auto& offset) { return !offset.first.starts_with("Head"); });
    }
    run.set = readConfiguredOffsets(configuration_);
    return run;
  });
  noteConfigured();
}

void CalibrationRuns::recordUndo(const std::map<std::string, double>& before) {
  record([&] {
    Run run = begin(std::string{undoKind});
    run.undoes = findRunOf(before, recording_.robot, readNewest(mostSearched)).value_or("");
    run.set = readConfiguredOffsets(configuration_);
    return run;
  });
  noteConfigured();
}

void CalibrationRuns::recordFall() {
  record([&] { return begin(std::string{fallKind}); });
}

void CalibrationRuns::noteConfigured() {
  noted_ = readConfiguredOffsets(configuration_);
}

void CalibrationRuns::recordSaved() {
  const std::map<std::string, double> offsets = readConfiguredOffsets(configuration_);
  if (offsets == noted_) {
    return;
  }
  record([&] {
    Run run = begin(std::string{applyKind});
    run.outcome = RunOutcome::kept;
    run.set = offsets;
    return run;
  });
  noted_ = offsets;
}

void CalibrationRuns::publishNewest() {
  if (recording_.folder.empty()) {
    return;
  }
  try {
    published_.write({readNewest(mostPublished)});
  } catch (const std::exception& error) {
    recording_.log(fmt::format("The robot's earlier runs are not shown: {}.", error.what()));
  }
}

std::vector<Run> CalibrationRuns::readNewest(std::size_t most) const {
  return RunFolder{recording_.folder}.readNewest(
      most, [&](const Run& run) { return isSameRobot(run.robot, recording_.robot); });
}

Run CalibrationRuns::begin(std::string kind) const {
  return {.time = presentTime(), .robot = recording_.robot, .kind = std::move(kind), .by = "naocal-robot"};
}

void CalibrationRuns::record(const std::function<Run()>& make) {
  if (recording_.folder.empty()) {
    return;
  }
  try {
    RunFolder{recording_.folder}.add(make());
    publishNewest();
  } catch (const std::exception& error) {
    recording_.log(fmt::format("This run is not recorded: {}.", error.what()));
  }
}

} // namespace naocal

#include "console/RecordApplied.hpp"

#include "calibration/Prediction.hpp"
#include "console/print/PrintText.hpp"
#include "data/CaptureSetFile.hpp"
#include "dialects/SavedCalibration.hpp"
#include "io/Files.hpp"
#include "io/JsonReader.hpp"
#include "io/StateFolder.hpp"
#include "runs/RobotHistory.hpp"
#include "runs/RunFile.hpp"
#include "runs/RunFolder.hpp"

#include <exception>
#include <nlohmann/json.hpp>
#include <vector>

namespace naocal {

namespace {

/// The rms errors on the result's captures with both calibrations, and where those captures are.
void addErrors(const LoadedCalibration& loaded, const ConfiguredBefore& before, const Configuration& after, Run& run) {
  if (loaded.folders.empty()) {
    return;
  }
  std::vector<CaptureSet> sets;
  for (const std::string& folder : loaded.folders) {
    sets.push_back(readCaptureSet(folder, BadCapturePolicy::skip).set);
  }
  const auto error = [&](const StoredResult& one) { return compare(one, sets, loaded.robot, false).all.rmsPx; };
  run.errorBefore = error(before.calibration);
  run.errorAfter = error(readConfiguredCalibration(after));
  run.captures = std::filesystem::absolute(loaded.folders.front()).lexically_normal().string();
  run.sha256 = sha256(readFile(std::filesystem::path{run.captures} / "captures.json"));
}

Run describeApplied(const AppliedResult& applied, const LoadedCalibration& loaded, const ConfiguredBefore& before,
                    const Configuration& after) {
  Run run{.time = presentTime(),
          .robot = applied.robot,
          .kind = std::string{applyKind},
          .by = "naocal apply",
          .outcome = RunOutcome::kept};
  run.result = std::filesystem::absolute(applied.result).lexically_normal().string();
  const auto document = parseJson(readFile(applied.result), applied.result);
  if (document.value("format", nlohmann::json{}) == "naocal-result") {
    run.offsets = offsetsOfResult(document, applied.result);
  }
  run.set = readConfiguredOffsets(after);
  addErrors(loaded, before, after, run);
  return run;
}

Run describeUndo(const AppliedResult& applied, const ConfiguredBefore& before, const Configuration& after) {
  Run run{.time = presentTime(), .robot = applied.robot, .kind = std::string{undoKind}, .by = "naocal apply --undo"};
  const RecordedRuns recorded = RunFolder{runsFolder(applied.state)}.read();
  run.undoes = findRunOf(before.offsets, run.robot, recorded.runs).value_or("");
  run.set = readConfiguredOffsets(after);
  return run;
}

} // namespace

std::filesystem::path runsFolder(const std::string& state) {
  return runsIn(state.empty() ? stateFolder() : std::filesystem::path{state});
}

ConfiguredBefore readBefore(const Configuration& configuration) {
  return {readConfiguredCalibration(configuration), readConfiguredOffsets(configuration)};
}

std::string recordApplied(const AppliedResult& applied, const LoadedCalibration& loaded, const ConfiguredBefore& before,
                          const Configuration& after) {
  try {
    const RunFolder runs{runsFolder(applied.state)};
    const Run run = runs.add(applied.isUndo ? describeUndo(applied, before, after)
                                            : describeApplied(applied, loaded, before, after));
    return (runs.path() / (run.id + ".json")).string();
  } catch (const std::exception& error) { // what was applied stands all the same
    printText(stderr, "not recorded in the robot's history: {}\n", error.what());
    return "";
  }
}

} // namespace naocal

#include "brain/CalibrationRecorder.hpp"

#include "brain/CalibrationInputs.hpp"
#include "calibration/Prediction.hpp"
#include "data/CaptureSetFile.hpp"
#include "detect/BoardDetector.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"
#include "io/Folders.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

CalibrationRecorder::CalibrationRecorder(const Robot& drawing, CaptureSet header, std::filesystem::path folder,
                                         ModelFile model)
    : drawing_{drawing}, set_{std::move(header)}, folder_{std::move(folder)}, model_{std::move(model)} {
  if (std::filesystem::exists(folder_ / "captures.json")) {
    throw InputError{fmt::format("{}: expected an empty folder for a new recording, found captures; move them away",
                                 folder_.string())};
  }
  createFolders(folder_ / "images");
}

std::vector<BoardCorners> CalibrationRecorder::record(Capture capture, const CameraFrame& frame) {
  const auto picture = toGreyImage(frame);
  if (!picture) {
    return {}; // incomplete image
  }
  capture.id = static_cast<int>(set_.captures.size());
  capture.image = fmt::format("images/{:04}.png", capture.id);
  capture.corners = detectBoards(*picture, set_.boards, set_.cameras.at(capture.camera)).boards;
  for (const BoardCorners& board : *capture.corners) {
    corners_ += board.ids.size();
  }
  writeImage(*picture, folder_ / capture.image);
  set_.captures.push_back(std::move(capture));
  writeCaptureSet(set_, folder_);
  return *set_.captures.back().corners;
}

CalibrationRecorder::Solution CalibrationRecorder::solve() const {
  const std::vector<CaptureSet> sets{set_};
  const Measurements measurements = buildMeasurements(sets, drawing_);
  const auto [asked, leftOut] = reduceModel(measurements, model_);
  const Model model = buildModel(measurements, asked.with, asked.without, asked.effects);
  const CalibrationResult result = calibrateChecked(measurements, model, {.effects = asked.effects});
  const ResultSources inputs{{"."}, {sha256(readFile(folder_ / "captures.json"))}, {set_.name}}; // beside the result
  writeAtomically(folder_ / "result.json", resultJson({measurements, model, result}, inputs).dump(2) + "\n");
  if (!result.converged) {
    throw InputError{
        "the search for offsets and mounts did not converge. Nothing was changed. Look whether all boards are "
        "those of the configuration and lie still, and calibrate again"};
  }
  if (!result.setUps.empty()) {
    throw InputError{result.sentence + " Nothing was changed."};
  }
  Solution solved{readResult(folder_ / "result.json"), effectiveOffsets({measurements, model, result}),
                  furtherThanVerdict(result.findings, measurements)};
  if (!leftOut.empty()) {
    solved.findings.push_back(
        makeFinding("accident", "model", FindingLevel::note,
                    fmt::format("The robot's model names what these captures know nothing of; it was left out: {}.",
                                fmt::join(leftOut, ", ")),
                    measurements));
  }
  nlohmann::json offsets; // [rad]
  for (const EffectiveOffset& offset : solved.offsets) {
    offsets[offset.joint] = {{"offset", offset.value}, {"sigma", offset.sigma}};
  }
  writeAtomically(folder_ / "offsets.json", offsets.dump(2) + "\n");
  return solved;
}

std::string CalibrationRecorder::diagnose() const {
  const std::vector<CaptureSet> sets{set_};
  const Measurements measurements = buildMeasurements(sets, drawing_);
  const ModelFile asked = reduceModel(measurements, model_).model;
  DiagnosisOptions options;
  options.with = asked.with;
  options.without = asked.without;
  options.calibration.effects = asked.effects;
  const Diagnosis diagnosis = naocal::diagnose(measurements, options);
  writeAtomically(folder_ / "diagnosis.json", diagnosisJson(diagnosis).dump(2) + "\n");
  return diagnosis.sentence;
}

CalibrationRecorder::ErrorComparison CalibrationRecorder::compareErrors(const StoredResult& before,
                                                                        const StoredResult& after) const {
  const auto rms = [this](const StoredResult& result) { return compare(result, {set_}, drawing_, false).all.rmsPx; };
  return {rms(before), rms(after)};
}

} // namespace naocal

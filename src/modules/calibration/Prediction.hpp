#pragma once

#include "calibration/result/ResultFile.hpp"

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// Reads a result file to predict with. Throws InputError as readResult does, and for effects that neither the
/// catalogue nor the result itself defines, which would be left out.
StoredResult readKnownResult(const std::filesystem::path& file);

/// How well a result predicts unseen captures.
struct Comparison {
  ResidualSummary all, nominal; // nominal: the same captures under the nominal model
  std::map<std::string, ResidualSummary> byBoard, byCamera, byPose;
  ReadingErrors readings, nominalReadings; // of measurements other than corners
  std::vector<std::string> ignored;        // terms of the result that do not apply to these captures
};

/// Predicts the measurements of `sets` from a result's estimates. Takes the placements that it has from the result, but
/// those of floor boards and stances only if `samePlace`; estimates all others.
Comparison compare(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace);

/// Error lengths one by one, for summaries over several predictions.
struct PredictionErrors {
  std::vector<double> pixels; // of corners [px]
  ReadingLengths readings;
};
PredictionErrors predictionErrors(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot,
                                  bool samePlace);

/// rms error per corner [px], accounting for the joints' random deflections at `noise`:
///
///   noise.pixel * sqrt(chi2 / corners),   chi2 = r^T (pixel^2 I + J_t S J_t^T)^-1 r,   outliers downweighted
///
/// Two results compared at the same noise then differ only by their predictions, not by the joints' random deflections.
double weightedError(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot,
                     bool samePlace, const Noise& noise);

/// COMPARISON.json (`naocal-compare`): errors [px] with the result and with the nominal model.
nlohmann::json comparisonJson(const Comparison& comparison);

/// A result's estimates transferred to unseen captures.
struct Prediction {
  Model model; // the result's terms that apply to these captures, and the placements
  Eigen::VectorXd unknowns;
  std::vector<bool> free;           // true for floor placements, unless `samePlace`
  std::vector<std::string> ignored; // terms of the result that do not apply to these captures
};
/// Builds the model for the new captures and takes the unknowns from the result.
Prediction preparePrediction(const StoredResult& result, const Measurements& measurements, bool samePlace);

} // namespace naocal

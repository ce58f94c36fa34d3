#pragma once

#include "calibration/Fit.hpp"
#include "calibration/ResultFile.hpp"

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// Distances of corners from their predictions: rms = sqrt(mean(du^2 + dv^2)).
struct ResidualSummary {
  double rmsPx = 0, medianPx = 0;
  std::size_t corners = 0;
};

/// How well a result predicts captures it has not seen.
struct Comparison {
  ResidualSummary all, nominal; // nominal: the same captures with the drawing as it is
  std::map<std::string, ResidualSummary> byBoard, byCamera, byPose;
  std::vector<std::string> ignored; // terms of the result that these captures do not touch
};

/// Predicts the corners of `sets` with a result's estimates. Placements of targets fixed to the robot are the result's;
/// those of floor boards and stances are estimated anew unless `samePlace`.
Comparison compare(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace);

/// rms error per corner [px] with the joints' random deflections of `noise` allowed for:
///
///   noise.pixel * sqrt(chi2 / corners),   chi2 = r^T (pixel^2 I + J_t S J_t^T)^-1 r,   false corners left out
///
/// Two results compared at the same noise differ by what they predict alone, not by how the joints happened to rest.
double weightedError(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot,
                     bool samePlace, const Noise& noise);

nlohmann::json comparisonJson(const Comparison& comparison);

/// A result's numbers on captures that it has not seen.
struct Prediction {
  Model model; // the result's terms as far as these captures touch them, and the placements
  Eigen::VectorXd unknowns;
  std::vector<bool> free;           // floor placements, unless the boards lie where they lay
  std::vector<std::string> ignored; // terms of the result that these captures do not touch
};
Prediction preparePrediction(const StoredResult& result, const Measurements& measurements, bool samePlace);
/// On a model that is there already.
Prediction preparePrediction(const Model& model, const StoredResult& result, const Measurements& measurements,
                             bool samePlace);

/// The least cost over what is free. Throws InputError where the captures cannot be predicted at all.
FitMinimum predict(Residuals& residuals, const Prediction& prediction);
FitMinimum predict(Residuals& residuals, const Prediction& prediction, const Residuals::State& start);

} // namespace naocal

#pragma once

#include "calibration/Prediction.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Errors on captures that the fit has not seen: poses are dealt to folds in turn, each fold is predicted, joint angles
/// as read, from a fit of the others.
struct FoldErrors {
  std::size_t folds = 0;
  PredictionErrors given, suggested; // of the model as given, and with what the diagnosis suggests
};

/// A model as given, and what a diagnosis suggests to add to it.
struct SuggestedModel {
  std::vector<std::string> with, without, suggested;
  std::vector<Effect> effects; // of a model file
};

/// `samePlace`: all sets share their world (buildMeasurements). Throws InputError for fewer poses than folds.
FoldErrors predictFolds(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace, std::size_t folds,
                        const SuggestedModel& model);

/// `crossValidated` of DIAGNOSIS.json.
nlohmann::json toJson(const FoldErrors& errors);

} // namespace naocal

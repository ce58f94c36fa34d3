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

/// `with`, `without`: the model as given. Throws InputError for fewer poses than folds.
FoldErrors crossValidate(const std::vector<CaptureSet>& sets, const Robot& robot, std::size_t folds,
                         const std::vector<std::string>& with, const std::vector<std::string>& without,
                         const std::vector<std::string>& suggested, const std::vector<Effect>& effects);

/// `crossValidated` of DIAGNOSIS.json.
nlohmann::json toJson(const FoldErrors& errors);

} // namespace naocal

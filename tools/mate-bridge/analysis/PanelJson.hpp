#pragma once

#include "analysis/Dataset.hpp"

#include "diagnosis/Diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A fit for the panel: verdict, estimates, every corner's residual by image, worst first, and the drivers recorded at
/// each image. Angles in degrees, lengths in millimetres. `document`: content of RESULT.json.
nlohmann::json fitJson(const nlohmann::json& document, const Dataset& opened, const FittedModel& fitted);

/// The available effects: name, description, formula, unknowns with their plausible size.
nlohmann::json effectsJson(const std::vector<Effect>& effects);

/// A diagnosis in the format of the report.
nlohmann::json diagnosisPanelJson(const Diagnosis& diagnosis);

/// The angles of a robot's motors: [{"joint", "value", "unit"}], in degrees, of slides in millimetres.
nlohmann::json anglesPanelJson(const Eigen::VectorXd& angles, const Robot& robot);

/// A model revision for the panel's history, with errors in the unit of the captures' errors.
nlohmann::json revisionPanelJson(const ModelRevision& rung, const ErrorUnit& errors);

} // namespace naocal

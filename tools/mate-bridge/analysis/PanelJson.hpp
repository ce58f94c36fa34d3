#pragma once

#include "analysis/Dataset.hpp"

#include "diagnosis/Diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A fit as the panel shows it: verdict, estimates, every corner's residual by picture, worst first, and what was
/// recorded at each picture. Angles in degrees, lengths in millimetres. `document`: as RESULT.json has it.
nlohmann::json fitJson(const nlohmann::json& document, const Dataset& opened, const FittedModel& fitted);

/// The effects that there are: name, what it is, formula, unknowns with what is plausible.
nlohmann::json effectsJson(const std::vector<Effect>& effects);

/// A diagnosis as the panel shows it; as in the report.
nlohmann::json diagnosisPanelJson(const Diagnosis& diagnosis);

/// A model that was tried, for the panel's ladder.
nlohmann::json revisionPanelJson(const ModelRevision& rung);

} // namespace naocal

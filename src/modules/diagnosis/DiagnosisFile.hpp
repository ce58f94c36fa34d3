#pragma once

#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/views/Figures.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// DIAGNOSIS.json: verdict, lack of fit, ranking, steps, curves, anomalies, figures. `mostPoints`: upper limit per
/// figure.
nlohmann::json diagnosisJson(const Diagnosis& diagnosis, std::size_t mostPoints = drawable);

} // namespace naocal

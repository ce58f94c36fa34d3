#pragma once

#include "diagnose/Diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// DIAGNOSIS.json: verdict, lack of fit, ranking, ladder, curves, suspicious captures.
nlohmann::json diagnosisJson(const Diagnosis& diagnosis);

/// The expression that follows a joint's curve as a person's own effect (`effects/UserEffect.hpp`). Every sigma is
/// twice what was found, so that captures decide.
nlohmann::json curveEffect(const DriverFinding& curve);

} // namespace naocal

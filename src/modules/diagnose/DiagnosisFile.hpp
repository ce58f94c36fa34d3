#pragma once

#include "diagnose/Diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// DIAGNOSIS.json: verdict, lack of fit, ranking, ladder, curves, suspicious captures.
nlohmann::json diagnosisJson(const Diagnosis& diagnosis);

} // namespace naocal

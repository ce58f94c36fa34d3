#pragma once

#include "diagnosis/DiagnosisResult.hpp"

namespace naocal {

/// Compares the model with the measurements, sees where it fails, learns which effects are missing, adds them as long
/// as the alarm stands, and says what remains.
Diagnosis diagnose(const Measurements& measurements, const DiagnosisOptions& options = {});

} // namespace naocal

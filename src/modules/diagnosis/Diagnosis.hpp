#pragma once

#include "diagnosis/DiagnosisResult.hpp"

namespace naocal {

/// Diagnoses the model: tests it against the captures, adds missing effects while the alarm persists, and reports the
/// verdict.
Diagnosis diagnose(const Measurements& measurements, const DiagnosisOptions& options = {});

} // namespace naocal

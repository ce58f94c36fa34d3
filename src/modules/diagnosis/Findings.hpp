#pragma once

#include "diagnosis/DiagnosisResult.hpp"

#include <vector>

namespace naocal {

/// What is suspicious, each as a finding of level stop. The first one's sentence is that of all (`formatAnomalies`).
/// Requires one.
std::vector<Finding> listAnomalies(const std::vector<DataAnomaly>& anomalies, const Measurements& measurements);

/// The findings of a diagnosis, most serious first. The first one's sentence is the diagnosis'; it stops where the
/// model as given must not be used, else something is to be done unless that model explains the captures. What holds of
/// the fit whatever is missing follows (`furtherThanVerdict`).
std::vector<Finding> listFindings(const Diagnosis& diagnosis, const Measurements& measurements);

} // namespace naocal

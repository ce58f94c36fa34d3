#pragma once

#include "diagnose/Diagnosis.hpp"

namespace naocal {

/// A model that was questioned, its fit, and what was found.
struct AskedModel {
  const Model& model;
  const CalibrationResult& fit;
  const Inquiry& inquiry;
};

/// Adds to a finished diagnosis what its figures show: which captures belong to each pose, how much alike the first
/// candidates are, what they would look like, and what the models leave over. `given`: the model as given.
void addFigures(const std::vector<CaptureSet>& sets, const Measurements& measurements, const AskedModel& given,
                const AskedModel& last, Diagnosis& diagnosis);

} // namespace naocal

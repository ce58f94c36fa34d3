#pragma once

#include "diagnose/Diagnosis.hpp"

namespace naocal {

/// Adds to a finished diagnosis what its figures show: which captures belong to each pose, how much alike the first
/// candidates are, and what they would look like. `first`: the inquiry into the model as given (`asked`).
void addViews(const std::vector<CaptureSet>& sets, const Measurements& measurements, const Model& asked,
              const Inquiry& first, Diagnosis& diagnosis);

} // namespace naocal

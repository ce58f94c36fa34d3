#pragma once

#include "SimulatedSets.hpp"
#include "calibration/Calibration.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/ModelBuilder.hpp"

#include <algorithm>
#include <vector>

namespace naocal {

/// A fitted base model with every testable candidate, linearised at the fit.
struct Questioned {
  Questioned(const CaptureSet& set, bool map, const std::vector<std::string>& with = {})
      : measurements{buildMeasurements({set}, loadRobot(configurationDirectory(), "V6"))},
        model{buildModel(measurements, with)}, fit{calibrate(measurements, model)},
        candidateTests{{measurements, model, fit}, testable(), {.draws = 0, .map = map}} {}

  std::vector<Term> testable() const { return testableTerms(measurements, model); }

  Measurements measurements;
  Model model;
  CalibrationResult fit;
  CandidateTests candidateTests;
};

} // namespace naocal

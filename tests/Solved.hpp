#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/Prediction.hpp"
#include "data/CaptureSetFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

/// A capture set and its calibration.
struct Solved {
  std::vector<CaptureSet> sets;
  Measurements measurements;
  Model model;
  CalibrationResult result;

  StoredResult stored() const {
    return parseResult(resultJson({measurements, model, result}, {{""}, {""}}), "result.json");
  }
};

inline Robot robotOf(const CaptureSet& set) {
  return loadRobot(configurationDirectory(), set.model);
}

inline Solved solved(const std::filesystem::path& folder, const std::vector<std::string>& with = {}) {
  Solved all{{readCaptureSet(folder).set}, {}, {}, {}};
  all.measurements = buildMeasurements(all.sets, robotOf(all.sets.front()));
  all.model = buildModel(all.measurements, with);
  all.result = calibrate(all.measurements, all.model);
  return all;
}

} // namespace naocal

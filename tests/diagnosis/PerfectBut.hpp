#pragma once

#include "Questioned.hpp"
#include "diagnosis/views/ResidualField.hpp"
#include "estimation/DriverState.hpp"

namespace naocal {

/// Replaces all corners by predictions of the fitted model plus an effect of this size.
inline CaptureSet perfectButFor(const Term& term, const Eigen::VectorXd& size, const Questioned& asked,
                                CaptureSet set) {
  Model model = asked.model;
  model.add(term);
  Eigen::VectorXd unknowns(asked.fit.unknowns.size() + size.size());
  unknowns << asked.fit.unknowns, size;
  for (const ImageObservation& picture : asked.measurements.pictures) {
    const auto boards =
        predictBoards(asked.measurements, picture, predictState(asked.measurements, model, picture, unknowns));
    for (std::size_t i = 0; i < boards.size(); ++i) {
      const BoardObservation& observation = picture.observations[i];
      const std::string& name = asked.measurements.targets[observation.view.board()].name;
      for (BoardCorners& seen : *set.captures[picture.capture].corners) {
        for (std::size_t k = 0; seen.board == name && k < seen.ids.size(); ++k) {
          const auto place =
              std::find(observation.ids.begin(), observation.ids.end(), seen.ids[k]) - observation.ids.begin();
          seen.uv[k] = boards[i].corners.col(place);
        }
      }
    }
  }
  return set;
}

/// Calibration with fixed noise and without outlier rejection.
inline CalibrationResult calibratedAt(const Noise& noise, const Measurements& measurements, const Model& model) {
  CalibrationOptions options;
  options.noise = noise;
  options.pixelGiven = true;
  options.estimateNoise = options.robust = options.excludeDisplaced = options.testMissingEffects = false;
  return calibrate(measurements, model, options);
}

} // namespace naocal

#pragma once

#include "calibrate/Fit.hpp"
#include "calibrate/ResultFile.hpp"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace naocal {

/// A result's numbers on captures that it has not seen.
struct Prediction {
  Model model; // the result's terms as far as these captures touch them, and the placements
  Eigen::VectorXd unknowns;
  std::vector<bool> free;           // floor placements, unless the boards lie where they lay
  std::vector<std::string> ignored; // terms of the result that these captures do not touch
};
Prediction predictionOf(const StoredResult& result, const Measurements& measurements, bool samePlace);
/// On a model that is there already.
Prediction predictionOf(const Model& model, const StoredResult& result, const Measurements& measurements,
                        bool samePlace);

/// The least cost over what is free. Throws InputError where the captures cannot be predicted at all.
FitMinimum predicted(Residuals& residuals, const Prediction& prediction);
FitMinimum predicted(Residuals& residuals, const Prediction& prediction, const Residuals::State& start);

} // namespace naocal

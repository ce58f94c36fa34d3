#pragma once

#include "calibration/CandidateTests.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace naocal {

/// Held-out prediction error: five folds of whole poses (all repeats and cameras together), each predicted from the
/// others, linearised at the fit. Directions that only the fold's own poses determine (placement of a stance) are
/// estimated from the fold.
///
/// Effects that were selected on all poses are selected anew in each fold from the other folds alone: the best of a
/// hundred candidates lowers the error on the poses it was selected on even if nothing is missing.
struct CrossValidation {
  double chosenPx = 0;         // rms distance of corners with the same number of effects, selected by the other folds
  double nextPx = 0;           // the same with one more effect
  double beforePx = 0;         // with the model as it is
  std::vector<double> afterPx; // with each of the requested candidates added
};
/// `chosen`: labels of the model's effects that were selected on these poses. `added`: candidates to evaluate, one or
/// several together per entry. Absent with a single pose.
std::optional<CrossValidation> crossValidate(const CandidateTests& candidateTests, const Model& model,
                                             const std::vector<std::string>& chosen,
                                             const std::vector<std::vector<std::size_t>>& added);

} // namespace naocal

#pragma once

#include "diagnosis/evidence/CandidateTests.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace naocal {

/// How well poses are predicted that neither the fit nor the choice of effects has seen: five folds of whole poses (all
/// repeats and cameras together), each predicted from the others, linearised at the fit. What only a fold's own poses
/// tell (where the robot stood then) is estimated from them.
///
/// Effects that were chosen on all poses are chosen anew in each fold, by the other folds alone: the best of a hundred
/// candidates lowers the error on the very poses that it was chosen on even where nothing is missing.
struct CrossValidation {
  double chosenPx = 0;         // rms distance of corners with as many effects as were chosen, chosen by the other folds
  double nextPx = 0;           // with one effect more, chosen likewise
  double beforePx = 0;         // with the model as it is
  std::vector<double> afterPx; // and with the candidates asked for
};
/// `chosen`: labels of the model's effects that were chosen on these poses. `added`: candidates that are asked for,
/// each time one or several together. Absent: there is one pose, and none to hold.
std::optional<CrossValidation> crossValidate(const CandidateTests& inquiry, const Model& model,
                                             const std::vector<std::string>& chosen,
                                             const std::vector<std::vector<std::size_t>>& added);

} // namespace naocal

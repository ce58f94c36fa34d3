#pragma once

#include "calibration/CandidateTests.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// Signature of an effect of a given size in otherwise perfect captures: corner displacement from the model without it,
/// before and after refitting that model.
struct EffectSignature {
  Eigen::VectorXd size;             // values of the effect's unknowns
  bool found = false;               // size was estimated; otherwise a plausible size
  double beforePx = 0, afterPx = 0; // rms over all corners of one picture per pose and camera [px]
  std::string imitator;             // label of the model's effect that alone mimics it best

  struct Seen {
    std::size_t picture = 0;
    double beforePx = 0, afterPx = 0;                 // rms over this picture's corners [px]
    Eigen::Matrix<double, 6, Eigen::Dynamic> corners; // a subset: u, v, displacement before, displacement after [px]
  };
  std::vector<Seen> pictures; // per camera those with the largest displacement, largest first, up to 180 corners
};

/// Signatures of these candidates, tested against `model` at its `fit`. A candidate with positive evidence has its
/// estimated size, others a plausible size in the direction of the estimate.
std::vector<EffectSignature> computeSignatures(const FittedModel& fitted, const CandidateTests& candidateTests,
                                               const std::vector<std::size_t>& candidates);

} // namespace naocal

#pragma once

#include "diagnosis/evidence/CandidateTests.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// What an effect of a certain size would do to these captures were they perfect otherwise: the corners' shift from
/// what the model without it shows, as it is and after that model is fitted to them.
struct EffectSignature {
  Eigen::VectorXd size;             // of the effect's unknowns
  bool found = false;               // the size that was found; else one that is plausible
  double beforePx = 0, afterPx = 0; // rms over all corners of one picture per pose and camera [px]
  std::string imitator;             // the model's own effect that alone follows it best

  struct Seen {
    std::size_t picture = 0;
    double beforePx = 0, afterPx = 0;                 // rms over this picture's corners [px]
    Eigen::Matrix<double, 6, Eigen::Dynamic> corners; // of some: u, v, their shift before, their shift after [px]
  };
  std::vector<Seen> pictures; // of each camera those that shift most, largest first, as many as show 180 corners
};

/// Of each of these candidates of an inquiry into `model` at its `fit`. A candidate that explains something has the
/// size that was found, another one goes that way as far as is plausible.
std::vector<EffectSignature> computeSignatures(const FittedModel& fitted, const CandidateTests& inquiry,
                                               const std::vector<std::size_t>& candidates);

} // namespace naocal

#pragma once

#include "diagnose/Inquiry.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// What one pose says about a candidate, both in standard errors of one number.
struct PoseTestimony {
  std::optional<std::size_t> pose; // absent: what was believed of the model's own unknowns before
  double signature = 0;            // how far one unit of the candidate moves the pose's pictures
  double residual = 0;             // how far they were measured to have moved that way
};

/// A candidate's added-variable plot, reduced to one point per pose (Cook and Weisberg 1982):
///
///   e = M g~ of the pose, signature = |e|, residual = -e . M r~ / |e|,
///   slope = sum(signature * residual) / sum(signature^2),  sigma = sum(signature^2)^-1/2
///
/// where M takes off what the model's own unknowns can follow. The slope over all points is the candidate's estimate.
/// A point stands left of zero where e moves the pose against the sense of `like`.
struct AddedVariable {
  std::vector<PoseTestimony> points;
  double slope = 0, sigma = 0; // [the unknown's unit]; of several unknowns: in units of their estimates together
  std::string like;            // the model's own effect that imitates the candidate best
};

/// Of a candidate effect; absent where the model absorbs it.
std::optional<AddedVariable> addedVariable(const Inquiry& inquiry, const Model& model, std::size_t candidate);

} // namespace naocal

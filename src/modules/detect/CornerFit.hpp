#pragma once

#include "detect/SmoothPicture.hpp"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace naocal {

/// Two places of the picture that the board's print makes equally bright: they mirror each other in the corner.
struct MirroredPair {
  Eigen::Vector2d one, other; // relative to the corner [px]
  double weight = 1;
  bool white = false; // whether they lie in the white squares beside the corner (else in the black ones)
};

/// What the picture shows around a place where four squares may meet.
struct CornerFit {
  Eigen::Vector2d place; // [px]
  double contrast = 0;   // white squares minus black ones [grey level]; negative: black and white are swapped
  double asymmetry = 0;  // 0: mirrors itself perfectly, 1: as if by chance, 2: each place meets its opposite
};

/// The place c, near `start`, around which the picture mirrors itself best:
///
///   minimise sum of weight * (grey(c + one) - grey(c + other))^2 over the pairs, by Gauss-Newton.
///
/// The pairs follow the board's perspective, so neither foreshortening nor blur nor spread ink shifts the result, and
/// long edges help although no marker's cells are used. Absent when the pairs leave the picture, nothing is there to
/// hold on to, or the place moves further than `maximalMove` [px].
std::optional<CornerFit> cornerFit(const SmoothPicture& picture, const std::vector<MirroredPair>& pairs,
                                   const Eigen::Vector2d& start, double maximalMove);

} // namespace naocal

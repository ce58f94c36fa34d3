#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace naocal {

/// A place on a board that has been seen.
struct SeenPoint {
  Eigen::Vector2d onBoard; // in squares
  Eigen::Vector2d seenAt;  // [px] with the lens's distortion removed
  double weight = 1;       // (unitSigma / sigma)^2
};
constexpr double unitSigma = 0.1; // [px] of a sighting with weight 1

/// The plane-to-picture map around a place on the board, seenAt = homography(onBoard).
///
/// Weighted direct linear transform: each sighting counts by its weight times 1 / (1 + (d / reach)^2)^2, d its distance
/// from `around`, so that what the lens model leaves and a board that is not quite flat matter little. Absent with
/// fewer than four sightings.
std::optional<Eigen::Matrix3d> localHomography(const std::vector<SeenPoint>& sightings, const Eigen::Vector2d& around);

} // namespace naocal

#pragma once

#include "residuals/Residuals.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace naocal {

/// What one pose says: y = J^T r / pixel^2 for the unknowns' columns J_x and the deflections' J_t. Each further column
/// holds another draw of r.
struct PoseScore {
  Eigen::MatrixXd unknowns, deflections;
};
using PoseScores = std::vector<PoseScore>;

/// Of the measurements themselves, at the unknowns where `linear` was taken.
PoseScores measuredScores(const Residuals::Linear& linear, const Noise& noise);

/// Of `draws` sets of residuals that are nothing but noise: r ~ N(0, pixel^2 I + J_t S J_t^T), hence
///   y ~ N(0, Q + Q_t S Q_t^T),   Q = J^T J / pixel^2,   S = root root^T.
/// The same seed gives the same draws.
PoseScores drawnScores(const Residuals::Linear& linear, const Noise& noise, Eigen::Index draws, std::uint64_t seed);

} // namespace naocal

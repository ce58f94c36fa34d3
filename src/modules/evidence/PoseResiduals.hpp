#pragma once

#include "residuals/Noise.hpp"
#include "residuals/PoseSystem.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace naocal {

/// Per pose its residuals [px], one row per row of `PoseRows`, one column per draw.
using PoseResiduals = std::vector<Eigen::MatrixXd>;

/// Those of the measurements themselves, where `poses` was linearised.
PoseResiduals measuredResiduals(const std::vector<PoseRows>& poses);

/// `draws` sets of residuals that are nothing but noise: r ~ N(0, pixel^2 I + J_t S J_t^T). The same seed gives the
/// same draws.
PoseResiduals drawnResiduals(const std::vector<PoseRows>& poses, const Noise& noise, Eigen::Index draws,
                             std::uint64_t seed);

} // namespace naocal

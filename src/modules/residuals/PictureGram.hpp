#pragma once

#include "model/Picture.hpp"
#include "residuals/Noise.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Sums over a sighting's corners, in the six numbers of the picture's motion and the extras: every derivative of the
/// sighting by any quantity is a column of `View::motion` times these, so their cost does not grow with the joints.
struct PictureGram {
  Eigen::MatrixXd gram;     // sum of w L^T L, (6 + extras) square
  Eigen::VectorXd gradient; // sum of w L^T r, r = predicted - measured
  double squares = 0;       // sum of w |r|^2 [px^2]
  double cost = 0;          // sum of rho     [1], in units of the pixel noise squared
  double corners = 0;       // with w > 0
};

/// `extraRows`: per extra and block, d(u) and d(v) (two lanes), extra after extra.
void sumUp(const CornerBlocks& corners, const ProjectedBlocks& projected,
           const std::vector<Lane, Eigen::aligned_allocator<Lane>>& extraRows, std::size_t extras, double pixelNoise,
           const Loss& loss, PictureGram& sums);

} // namespace naocal

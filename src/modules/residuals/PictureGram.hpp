#pragma once

#include "model/Picture.hpp"
#include "residuals/Noise.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// d(u), d(v) of four corners per unit of an extra (`View::extraRows`).
struct ExtraRow {
  Lane u, v;
};

/// Sums over corners, in the six numbers of the picture's motion and the extras: every derivative by any quantity is a
/// column of `View::motion` times these, so their cost does not grow with the joints.
class PictureGram {
public:
  static constexpr int most = 6 + static_cast<int>(extraCount);
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;

  /// Forgets all corners.
  void clear(std::size_t extras = 0);

  /// Adds a sighting's corners. `extraRows`: extra after extra, each block after block.
  void add(const CornerBlocks& corners, const ProjectedBlocks& projected, const std::vector<ExtraRow>& extraRows,
           double pixelNoise, const Loss& loss);

  Square gram() const;                             // sum of w L^T L, 6 + extras
  Column gradient() const;                         // sum of w L^T r, r = predicted - measured
  double squares() const { return sum(squares_); } // sum of w |r|^2 [px^2]
  double cost() const { return sum(cost_); }       // sum of rho [1], in units of the pixel noise squared
  double corners() const { return sum(corners_); } // with w > 0

private:
  std::size_t width_ = 0;                // 6 + extras
  Lane products_[most * (most + 1) / 2]; // the gram's lower triangle, row after row
  Lane gradient_[most];
  Lane squares_, cost_, corners_;
};

} // namespace naocal

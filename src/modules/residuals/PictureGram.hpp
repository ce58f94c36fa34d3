#pragma once

#include "camera/ObservationChain.hpp"
#include "residuals/Noise.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// d(u), d(v) of four corners per unit of an extra (`View::extraRows`).
struct ExtraRow {
  Lane u, v;
};

/// How far a sighting's corners count (`cornerShare`), among `repeats` pictures of one rest.
struct SightingWeight {
  double share = 1;
  std::size_t repeats = 1;
  /// Mean of share |r|^2 / pixel^2 per number: the repeats' mean has variance pixel^2 / share / repeats, differences
  /// from it have pixel^2.
  double freedom() const { return share + (1 - share) / static_cast<double>(repeats); }
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
           double pixelNoise, const SightingWeight& weight, const Loss& loss);

  Square gram() const;                             // sum of w L^T L, 6 + extras
  Column gradient() const;                         // sum of w L^T r, r = predicted - measured
  double squares() const { return sum(squares_); } // sum of w |r|^2 [px^2]
  double cost() const { return sum(cost_); }       // sum of rho [1], in units of the pixel noise squared
  double corners() const { return sum(corners_); } // sum of shares of those with w > 0
  double freedom() const { return sum(freedom_); } // what squares / pixel^2 of as many is in the mean

private:
  std::size_t width_ = 0;                // 6 + extras
  Lane products_[most * (most + 1) / 2]; // the gram's lower triangle, row after row
  Lane gradient_[most];
  Lane squares_, cost_, corners_, freedom_;
};

} // namespace naocal

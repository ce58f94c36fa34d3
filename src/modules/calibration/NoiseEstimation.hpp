#pragma once

#include "estimation/Residuals.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// Pixel noise estimated from repeats [px, per axis], without a model of the robot. For each camera's and board's
/// corners in one pose, x_r, the fields of a homography (eight) and of a lens (four) are projected out. Over all these
/// cells, with R repeats of n corners each:
///
///   anew^2  = sum_r |x_r - mean|^2 / ((R - 1) (2n - 12)),
///   alike^2 = (R |mean|^2 / (2n - 12) - anew^2) / R,  at least 0
///
/// (one-way analysis of variance, restricted likelihood in closed form: Searle, Casella and McCulloch, Variance
/// components, 1992, chapter 4). `alike` needs repeats at rest: after a re-approach corners fall on other subpixel
/// positions, and their error is new noise.
struct PixelNoise {
  double anew = 0, alike = 0;
  /// Upper limit of `alike` [px], the subpixel bias of corner detectors. More is misfit of lens or board.
  static constexpr double mostAlike = 0.05;
};
/// Absent with fewer than 20 degrees of freedom from repeats.
std::optional<PixelNoise> estimatePixelNoiseFromRepeats(const Measurements& measurements,
                                                        const std::vector<BoardResidual>& observations);

/// Pixel noise [px] within single images: rms of the residuals after projecting out each board's rigid motion. Errors
/// of lens and board shape count as noise. Absent if no image shows at least eight good corners of a board.
std::optional<double> estimatePixelNoiseWithinImages(const std::vector<BoardResidual>& observations);

} // namespace naocal

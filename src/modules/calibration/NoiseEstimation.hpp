#pragma once

#include "estimation/Residuals.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// The pixel noise that repeats show [px, per axis]. No model of the robot enters: of each camera's and board's corners
/// in one pose, x_r, the fields of a homography (eight) and of a lens (four) are taken out. Over all these cells, R
/// repeats of n corners each:
///
///   anew^2  = sum_r |x_r - mean|^2 / ((R - 1) (2n - 8)),
///   alike^2 = (R |mean|^2 / (2n - 8) - anew^2) / R,  at least 0
///
/// (one-way analysis of variance, restricted likelihood in closed form: Searle, Casella and McCulloch, Variance
/// components, 1992, chapter 4). What repeats alike is told at rest only: after a re-approach corners lie elsewhere
/// between the pixels, and it is new noise.
struct PixelNoise {
  double anew = 0, alike = 0;
  /// More than a corner detector's place between the pixels does is misfit of lens or board, not noise [px].
  static constexpr double mostAlike = 0.05;
};
/// Absent without repeats.
std::optional<PixelNoise> estimatePixelNoiseFromRepeats(const Measurements& measurements,
                                                        const std::vector<BoardResidual>& sightings);

/// The pixel noise [px] within single pictures: residuals after the picture's rigid motion is taken out. A lens or a
/// board that is not as drawn counts as noise here. Absent where no picture shows enough corners (eight) of a board.
std::optional<double> estimatePixelNoiseWithinImages(const std::vector<BoardResidual>& sightings);

} // namespace naocal

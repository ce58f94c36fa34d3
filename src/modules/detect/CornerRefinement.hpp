#pragma once

#include "io/GreyImage.hpp"

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace naocal {

/// A slightly blurred picture as a smooth function of position: bicubic interpolation (Catmull-Rom).
class SmoothImage {
public:
  /// `blur`: sigma of the Gaussian [px].
  SmoothImage(const GreyPicture& picture, double blur);

  struct Sample {
    double grey = 0;                                    // [grey level]
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero(); // [grey level/px]
  };
  /// Requires `contains(place)`.
  Sample sample(const Eigen::Vector2d& place) const;

  /// Whether all pixels needed to sample at a position lie in the picture.
  bool contains(const Eigen::Vector2d& place) const {
    return place.x() >= 1 && place.y() >= 1 && place.x() < width_ - 2 && place.y() < height_ - 2;
  }

private:
  int width_, height_;
  std::vector<float> pixels_;
};

/// Two positions of equal brightness in the board's print: point reflections of each other in the corner.
struct SymmetricPair {
  Eigen::Vector2d one, other; // relative to the corner [px]
  double weight = 1;
  bool white = false; // in the white squares beside the corner (otherwise in the black ones)
};

/// Result of refining a corner, a crossing of four squares.
struct CornerFit {
  Eigen::Vector2d place; // [px]
  double contrast = 0;   // white minus black squares [grey level]; negative: black and white are swapped
  double asymmetry = 0;  // 0: perfectly symmetric, 1: random, 2: each position meets its inverse
};

/// Position c near `start` with the best point symmetry of the picture:
///
///   minimise sum of weight * (grey(c + one) - grey(c + other))^2 over the pairs, by Gauss-Newton.
///
/// The pairs follow the board's perspective, so foreshortening, blur and ink spread do not bias the result. Long edges
/// contribute, although no marker cells are used. Absent if the pairs leave the picture, there is no texture, or the
/// position moves farther than `maximalMove` [px].
std::optional<CornerFit> fitCorner(const SmoothImage& picture, const std::vector<SymmetricPair>& pairs,
                                   const Eigen::Vector2d& start, double maximalMove);

/// A known point of a board and its position in the picture.
struct PointMatch {
  Eigen::Vector2d onBoard; // in squares
  Eigen::Vector2d seenAt;  // [px] with lens distortion removed
  double weight = 1;       // (unitSigma / sigma)^2
};
constexpr double unitSigma = 0.1; // [px] of a match with weight 1

/// Homography from board to picture around a point of the board, seenAt = homography(onBoard).
///
/// Weighted direct linear transform: each match counts by its weight times 1 / (1 + (d / scope)^2)^2, d its distance
/// from `around`, scope = 2 squares, which limits the influence of lens model errors and uneven boards. Absent with
/// fewer than four matches.
std::optional<Eigen::Matrix3d> fitLocalHomography(const std::vector<PointMatch>& observations,
                                                  const Eigen::Vector2d& around);

/// The window for refining a corner: pairs of opposite points on the board.
///
/// Extends `reach` squares in each direction of the board, but at least 2 px (minimum of information) and at most 7 px
/// (cost), so it follows the board's perspective. The weight falls towards the rim. `pixelFromBoard` maps squares to
/// pixels; `risingIsWhite`: the squares at the upper right and lower left are white.
std::vector<SymmetricPair> symmetricPairs(const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& pixelFromBoard,
                                          const Eigen::Vector2d& corner, double reach, bool risingIsWhite);

} // namespace naocal

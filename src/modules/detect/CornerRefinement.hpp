#pragma once

#include "io/GreyImage.hpp"

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace naocal {

/// A picture, slightly blurred, as a smooth function of the place: bicubic (Catmull-Rom) between its pixels.
class SmoothImage {
public:
  /// `blur`: sigma of the Gaussian [px].
  SmoothImage(const GreyPicture& picture, double blur);

  struct Sample {
    double grey = 0;                                    // [grey level]
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero(); // [grey level/px]
  };
  /// `place` must satisfy `contains(place)`.
  Sample sample(const Eigen::Vector2d& place) const;

  /// Whether all pixels around a place that its sample needs lie in the picture.
  bool contains(const Eigen::Vector2d& place) const {
    return place.x() >= 1 && place.y() >= 1 && place.x() < width_ - 2 && place.y() < height_ - 2;
  }

private:
  int width_, height_;
  std::vector<float> pixels_;
};

/// Two places of the picture that the board's print makes equally bright: they mirror each other in the corner.
struct SymmetricPair {
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
std::optional<CornerFit> fitCorner(const SmoothImage& picture, const std::vector<SymmetricPair>& pairs,
                                   const Eigen::Vector2d& start, double maximalMove);

/// A place on a board that has been seen.
struct PointMatch {
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
std::optional<Eigen::Matrix3d> fitLocalHomography(const std::vector<PointMatch>& sightings,
                                                  const Eigen::Vector2d& around);

/// The window in which a corner is fitted: pairs of places opposite to each other on the board.
///
/// In each direction of the board it reaches `reach` squares, but at least 2 px (less tells nothing) and at most 7 px
/// (more costs time); so it is as flat in the picture as the board. The weight falls towards its rim.
/// `pixelFromBoard` maps squares to pixels; `risingIsWhite`: the squares at the upper right and lower left are white.
std::vector<SymmetricPair> symmetricPairs(const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& pixelFromBoard,
                                          const Eigen::Vector2d& corner, double reach, bool risingIsWhite);

} // namespace naocal

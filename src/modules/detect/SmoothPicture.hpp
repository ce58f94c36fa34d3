#pragma once

#include "captures/GreyPicture.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// A picture, slightly blurred, as a smooth function of the place: bicubic (Catmull-Rom) between its pixels.
class SmoothPicture {
public:
  /// `blur`: sigma of the Gaussian [px].
  SmoothPicture(const GreyPicture& picture, double blur);

  struct Sample {
    double grey = 0;                                    // [grey level]
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero(); // [grey level/px]
  };
  /// `place` must satisfy `holds(place)`.
  Sample at(const Eigen::Vector2d& place) const;

  /// Whether all pixels around a place that its sample needs lie in the picture.
  bool holds(const Eigen::Vector2d& place) const {
    return place.x() >= 1 && place.y() >= 1 && place.x() < width_ - 2 && place.y() < height_ - 2;
  }

private:
  int width_, height_;
  std::vector<float> pixels_;
};

} // namespace naocal

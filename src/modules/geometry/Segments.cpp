#include "geometry/Segments.hpp"

#include <algorithm>

namespace naocal {

double segmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                       const Eigen::Vector3d& s) {
  const Eigen::Vector3d along = q - p, other = s - r, between = p - r;
  const double a = along.squaredNorm(), e = other.squaredNorm(), b = along.dot(other);
  const double c = along.dot(between), f = other.dot(between);
  const auto clamped = [](double numerator, double denominator) {
    return denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
  };
  // The nearest place on p..q for both lines, the nearest to it on r..s, and back where that was cut off at an end.
  double onFirst = clamped(b * f - c * e, a * e - b * b);
  const double onOther = clamped(b * onFirst + f, e);
  onFirst = clamped(b * onOther - c, a);
  return (p + onFirst * along - r - onOther * other).norm();
}

} // namespace naocal

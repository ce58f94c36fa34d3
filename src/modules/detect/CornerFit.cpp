#include "detect/CornerFit.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace naocal {
namespace {

constexpr int iterations = 20;
constexpr double longestStep = 0.7, negligibleStep = 1e-3; // [px]

/// One Gauss-Newton step from `place`; absent at the picture's edge or without texture.
std::optional<Eigen::Vector2d> step(const SmoothPicture& picture, const std::vector<MirroredPair>& pairs,
                                    const Eigen::Vector2d& place) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const MirroredPair& pair : pairs) {
    if (!picture.holds(place + pair.one) || !picture.holds(place + pair.other)) {
      return std::nullopt;
    }
    const auto one = picture.at(place + pair.one), other = picture.at(place + pair.other);
    const Eigen::Vector2d slope = one.gradient - other.gradient;
    normal += pair.weight * slope * slope.transpose();
    right -= pair.weight * (one.grey - other.grey) * slope;
  }
  if (normal.determinant() <= 1e-9) {
    return std::nullopt;
  }
  const Eigen::Vector2d full = normal.inverse() * right;
  return full * std::min(1., longestStep / full.norm());
}

CornerFit judged(const SmoothPicture& picture, const std::vector<MirroredPair>& pairs, const Eigen::Vector2d& place) {
  double weight[2] = {}, sum[2] = {}, squares = 0, differences = 0;
  for (const MirroredPair& pair : pairs) {
    const double one = picture.at(place + pair.one).grey, other = picture.at(place + pair.other).grey;
    weight[pair.white] += 2 * pair.weight;
    sum[pair.white] += pair.weight * (one + other);
    squares += pair.weight * (one * one + other * other);
    differences += pair.weight * (one - other) * (one - other);
  }
  const double all = weight[0] + weight[1];
  const double variance = squares / all - std::pow((sum[0] + sum[1]) / all, 2);
  return {place, sum[1] / weight[1] - sum[0] / weight[0], differences / (all * variance)};
}

} // namespace

std::optional<CornerFit> cornerFit(const SmoothPicture& picture, const std::vector<MirroredPair>& pairs,
                                   const Eigen::Vector2d& start, double maximalMove) {
  Eigen::Vector2d place = start;
  for (int i = 0; i < iterations; ++i) {
    const auto move = step(picture, pairs, place);
    if (!move || (place + *move - start).norm() > maximalMove) {
      return std::nullopt;
    }
    place += *move;
    if (move->norm() < negligibleStep) {
      break;
    }
  }
  const bool inside = std::all_of(pairs.begin(), pairs.end(), [&](const MirroredPair& pair) {
    return picture.holds(place + pair.one) && picture.holds(place + pair.other);
  });
  return inside ? std::optional{judged(picture, pairs, place)} : std::nullopt;
}

} // namespace naocal

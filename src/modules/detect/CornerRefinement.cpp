#include "detect/CornerRefinement.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace naocal {

namespace {

constexpr int iterations = 20;

constexpr double longestStep = 0.7, negligibleStep = 1e-3; // [px]

/// One Gauss-Newton step from `place`; absent at the edge of the picture or without texture.
std::optional<Eigen::Vector2d> step(const SmoothImage& picture, const std::vector<SymmetricPair>& pairs,
                                    const Eigen::Vector2d& place) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const SymmetricPair& pair : pairs) {
    if (!picture.contains(place + pair.one) || !picture.contains(place + pair.other)) {
      return std::nullopt;
    }
    const auto one = picture.sample(place + pair.one), other = picture.sample(place + pair.other);
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

CornerFit judgeCorner(const SmoothImage& picture, const std::vector<SymmetricPair>& pairs,
                      const Eigen::Vector2d& place) {
  double weight[2] = {}, sum[2] = {}, squares = 0, differences = 0;
  for (const SymmetricPair& pair : pairs) {
    const double one = picture.sample(place + pair.one).grey, other = picture.sample(place + pair.other).grey;
    weight[pair.white] += 2 * pair.weight;
    sum[pair.white] += pair.weight * (one + other);
    squares += pair.weight * (one * one + other * other);
    differences += pair.weight * (one - other) * (one - other);
  }
  const double all = weight[0] + weight[1];
  const double variance = squares / all - std::pow((sum[0] + sum[1]) / all, 2);
  return {place, sum[1] / weight[1] - sum[0] / weight[0], differences / (all * variance)};
}

constexpr double scope = 2; // [squares]

constexpr double perspective = 0.1; // prior of the perspective change per square; stabilises four noisy corners

/// Similarity that centres the matches and scales their spread to about one.
Eigen::Matrix3d normalisation(const std::vector<PointMatch>& observations) {
  double sum = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const PointMatch& one : observations) {
    sum += one.weight;
    mean += one.weight * one.seenAt;
  }
  mean /= sum;
  double spread = 0;
  for (const PointMatch& one : observations) {
    spread += one.weight * (one.seenAt - mean).squaredNorm();
  }
  const double scale = std::sqrt(2 * sum / spread);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix.topLeftCorner<2, 2>() *= scale;
  matrix.topRightCorner<2, 1>() = -scale * mean;
  return matrix;
}

constexpr double narrowest = 2.0, widest = 7.0; // half the window [px]

constexpr double spacing = 0.7; // of the sample points [px]

/// Half extent of the window in one direction of the board.
struct Half {
  double squares = 0;
  int places = 0; // sample points on either side of the corner
};

Half half(double pixelsPerSquare, double reach) {
  const double pixels = std::clamp(reach * pixelsPerSquare, narrowest, widest);
  return {pixels / pixelsPerSquare, int(std::ceil(pixels / spacing))};
}

/// Catmull-Rom weights of the pixels at -1, 0, 1, 2 for a position `t` in [0, 1), and their derivatives with respect to
/// `t`.
struct CubicWeights {
  explicit CubicWeights(double t)
      : value{0.5 * t * (-1 + t * (2 - t)), 1 + 0.5 * t * t * (-5 + 3 * t), 0.5 * t * (1 + t * (4 - 3 * t)),
              0.5 * t * t * (t - 1)},
        slope{0.5 * (-1 + t * (4 - 3 * t)), 0.5 * t * (-10 + 9 * t), 0.5 * (1 + t * (8 - 9 * t)),
              0.5 * t * (3 * t - 2)} {}
  std::array<double, 4> value, slope;
};

} // namespace

std::optional<CornerFit> fitCorner(const SmoothImage& picture, const std::vector<SymmetricPair>& pairs,
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
  const bool inside = std::all_of(pairs.begin(), pairs.end(), [&](const SymmetricPair& pair) {
    return picture.contains(place + pair.one) && picture.contains(place + pair.other);
  });
  return inside ? std::optional{judgeCorner(picture, pairs, place)} : std::nullopt;
}

std::optional<Eigen::Matrix3d> fitLocalHomography(const std::vector<PointMatch>& observations,
                                                  const Eigen::Vector2d& around) {
  if (observations.size() < 4) {
    return std::nullopt;
  }
  const Eigen::Matrix3d normalised = normalisation(observations);
  Eigen::Matrix<double, 9, 9> normal = Eigen::Matrix<double, 9, 9>::Zero();
  for (const PointMatch& one : observations) {
    const Eigen::Vector3d x = (one.onBoard - around).homogeneous();
    const Eigen::Vector2d u = (normalised * one.seenAt.homogeneous()).head<2>();
    const double nearness = 1 / (1 + (one.onBoard - around).squaredNorm() / (scope * scope));
    Eigen::Matrix<double, 2, 9> rows;
    rows << x.transpose(), Eigen::RowVector3d::Zero(), -u.x() * x.transpose(), //
        Eigen::RowVector3d::Zero(), x.transpose(), -u.y() * x.transpose();
    normal += one.weight * nearness * nearness * rows.transpose() * rows;
  }
  const double scale = normalised(0, 0);
  normal.diagonal().segment<2>(6).array() += std::pow(scale * unitSigma / perspective, 2);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> solver{normal};
  const Eigen::Matrix<double, 9, 1> h = solver.eigenvectors().col(0);
  Eigen::Matrix3d centred;
  centred << h.head<3>().transpose(), h.segment<3>(3).transpose(), h.tail<3>().transpose();
  Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
  shift.topRightCorner<2, 1>() = -around;
  return normalised.inverse() * centred * shift;
}

std::vector<SymmetricPair> symmetricPairs(const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& pixelFromBoard,
                                          const Eigen::Vector2d& corner, double reach, bool risingIsWhite) {
  const Eigen::Vector2d centre = pixelFromBoard(corner);
  const auto pixelsPerSquare = [&](const Eigen::Vector2d& direction) {
    return (pixelFromBoard(corner + 0.1 * direction) - pixelFromBoard(corner - 0.1 * direction)).norm() / 0.2;
  };
  const Half x = half(pixelsPerSquare(Eigen::Vector2d::UnitX()), reach);
  const Half y = half(pixelsPerSquare(Eigen::Vector2d::UnitY()), reach);
  std::vector<SymmetricPair> pairs;
  for (int row = 0; row < y.places; ++row) {
    for (int column = -x.places; column < x.places; ++column) {
      const double shareX = (column + 0.5) / x.places, shareY = (row + 0.5) / y.places;
      const Eigen::Vector2d offset{shareX * x.squares, shareY * y.squares};
      pairs.push_back({pixelFromBoard(corner + offset) - centre, pixelFromBoard(corner - offset) - centre,
                       (1 - shareX * shareX) * (1 - shareY * shareY), (column >= 0) == risingIsWhite});
    }
  }
  return pairs;
}

SmoothImage::SmoothImage(const GreyPicture& picture, double blur)
    : width_{picture.width}, height_{picture.height}, pixels_(picture.pixels.size()) {
  // OpenCV requires a mutable pointer but only reads.
  const cv::Mat sharp(height_, width_, CV_8U, const_cast<std::uint8_t*>(picture.pixels.data()));
  cv::Mat1f smooth(height_, width_, pixels_.data());
  sharp.convertTo(smooth, CV_32F);
  cv::GaussianBlur(smooth, smooth, {}, blur);
}

SmoothImage::Sample SmoothImage::sample(const Eigen::Vector2d& place) const {
  assert(contains(place));
  const int left = int(place.x()), top = int(place.y());
  const CubicWeights x{place.x() - left}, y{place.y() - top};
  Sample sample;
  for (int row = 0; row < 4; ++row) {
    const float* pixel = &pixels_[std::size_t(top + row - 1) * std::size_t(width_) + std::size_t(left - 1)];
    double value = 0, slope = 0;
    for (std::size_t column = 0; column < 4; ++column) {
      value += x.value[column] * double(pixel[column]);
      slope += x.slope[column] * double(pixel[column]);
    }
    sample.grey += y.value[std::size_t(row)] * value;
    sample.gradient += Eigen::Vector2d{y.value[std::size_t(row)] * slope, y.slope[std::size_t(row)] * value};
  }
  return sample;
}

} // namespace naocal

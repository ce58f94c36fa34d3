#include "detect/SmoothPicture.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace naocal {
namespace {

/// Weights of the pixels at -1, 0, 1, 2 for a place at `t` in [0, 1), and their derivatives by `t`.
struct CubicWeights {
  explicit CubicWeights(double t)
      : value{0.5 * t * (-1 + t * (2 - t)), 1 + 0.5 * t * t * (-5 + 3 * t), 0.5 * t * (1 + t * (4 - 3 * t)),
              0.5 * t * t * (t - 1)},
        slope{0.5 * (-1 + t * (4 - 3 * t)), 0.5 * t * (-10 + 9 * t), 0.5 * (1 + t * (8 - 9 * t)),
              0.5 * t * (3 * t - 2)} {}
  std::array<double, 4> value, slope;
};

} // namespace

SmoothPicture::SmoothPicture(const GreyPicture& picture, double blur)
    : width_{picture.width}, height_{picture.height}, pixels_(picture.pixels.size()) {
  // OpenCV wants a mutable pointer but only reads.
  const cv::Mat sharp(height_, width_, CV_8U, const_cast<std::uint8_t*>(picture.pixels.data()));
  cv::Mat1f smooth(height_, width_, pixels_.data());
  sharp.convertTo(smooth, CV_32F);
  cv::GaussianBlur(smooth, smooth, {}, blur);
}

SmoothPicture::Sample SmoothPicture::at(const Eigen::Vector2d& place) const {
  assert(holds(place));
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

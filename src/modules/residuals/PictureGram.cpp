#include "residuals/PictureGram.hpp"

#include <algorithm>

namespace naocal {

namespace {

/// The loss of four corners and its slope, their weight, where the loss is not quadratic.
void weigh(const Lane& squaredDistance, const Loss& loss, Lane& rho, Lane& weight) {
  for (int i = 0; i < 4; ++i) {
    const auto [value, slope] = loss(squaredDistance[i]);
    rho[i] *= value;
    weight[i] *= slope;
  }
}

} // namespace

void PictureGram::clear(std::size_t extras) {
  width_ = 6 + extras;
  std::fill_n(products_, width_ * (width_ + 1) / 2, Lane{});
  std::fill_n(gradient_, width_, Lane{});
  squares_ = cost_ = corners_ = freedom_ = Lane{};
}

void PictureGram::add(const CornerBlocks& corners, const ProjectedBlocks& projected,
                      const std::vector<ExtraRow>& extraRows, double pixelNoise, const SightingWeight& weight,
                      const Loss& loss) {
  const double share = weight.share, freedom = weight.freedom();
  const double information = share / (pixelNoise * pixelNoise);
  const std::size_t blocks = corners.size();
  const bool quadratic = loss.scale == 0;
  withWidestVectors([ =, this, &corners, &projected, &extraRows, &loss ]() __attribute__((always_inline)) {
    Lane squares{}, cost{}, counted{};
    for (std::size_t block = 0; block < blocks; ++block) {
      const ProjectedBlock& seen = projected[block];
      const Lane ru = seen.u - corners[block].u, rv = seen.v - corners[block].v;
      const Lane rr = ru * ru + rv * rv;
      Lane w = corners[block].present, rho = w;
      if (quadratic) {
        rho *= information * rr;
      } else {
        weigh(information * rr, loss, rho, w);
      }
      counted += w > 0 ? Lane{} + 1 : Lane{};
      w *= share;
      squares += w * rr;
      cost += rho;
      Lane* product = products_;
#pragma GCC unroll 6
      for (std::size_t i = 0; i < 6; ++i) {
        const Lane wu = w * seen.rowsU[i], wv = w * seen.rowsV[i];
        gradient_[i] = gradient_[i] + wu * ru + wv * rv;
#pragma GCC unroll 6
        for (std::size_t j = 0; j <= i; ++j, ++product) {
          *product = *product + wu * seen.rowsU[j] + wv * seen.rowsV[j];
        }
      }
      for (std::size_t i = 6; i < width_; ++i) {
        const ExtraRow& row = extraRows[(i - 6) * blocks + block];
        const Lane wu = w * row.u, wv = w * row.v;
        gradient_[i] += wu * ru + wv * rv;
        for (std::size_t j = 0; j < 6; ++j) {
          *product++ += wu * seen.rowsU[j] + wv * seen.rowsV[j];
        }
        for (std::size_t j = 6; j <= i; ++j) {
          const ExtraRow& other = extraRows[(j - 6) * blocks + block];
          *product++ += wu * other.u + wv * other.v;
        }
      }
    }
    squares_ += squares;
    cost_ += cost;
    corners_ += share * counted;
    freedom_ += freedom * counted;
  });
}

PictureGram::Square PictureGram::gram() const {
  const auto width = static_cast<Eigen::Index>(width_);
  Square result(width, width);
  const Lane* product = products_;
  for (Eigen::Index i = 0; i < width; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      result(i, j) = result(j, i) = sum(*product++);
    }
  }
  return result;
}

PictureGram::Column PictureGram::gradient() const {
  Column result(static_cast<Eigen::Index>(width_));
  for (std::size_t i = 0; i < width_; ++i) {
    result[static_cast<Eigen::Index>(i)] = sum(gradient_[i]);
  }
  return result;
}

} // namespace naocal

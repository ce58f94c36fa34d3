#include "residuals/PictureGram.hpp"

namespace naocal {

namespace {

/// The loss's weight of each of four corners, and its sum of rho.
Lane weights(const Lane& squaredDistance, const Lane& present, const Loss& loss, double& rho) {
  if (loss.scale == 0) {
    rho += (squaredDistance * present).sum();
    return present;
  }
  Lane result;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const auto [value, weight] = loss(squaredDistance[i]);
    rho += present[i] * value;
    result[i] = present[i] * weight;
  }
  return result;
}

/// The lower triangle of sum w L^T L over four corners, added to sums[i (i + 1) / 2 + j].
template <std::size_t Count> void addSix(const Lane (&u)[Count], const Lane (&v)[Count], const Lane& w, Lane* sums) {
  for (std::size_t i = 0; i < Count; ++i) {
    const Lane wu = w * u[i], wv = w * v[i];
    for (std::size_t j = 0; j <= i; ++j) {
      *sums++ += wu * u[j] + wv * v[j];
    }
  }
}

} // namespace

void sumUp(const CornerBlocks& corners, const ProjectedBlocks& projected,
           const std::vector<Lane, Eigen::aligned_allocator<Lane>>& extraRows, std::size_t extras, double pixelNoise,
           const Loss& loss, PictureGram& sums) {
  const std::size_t width = 6 + extras;
  const double information = 1 / (pixelNoise * pixelNoise);
  const Lane zero = Lane::Zero();
  Lane grams[21], gradients[6];
  std::fill(std::begin(grams), std::end(grams), zero);
  std::fill(std::begin(gradients), std::end(gradients), zero);
  Lane squares = zero, counted = zero;
  sums.gram.setZero(static_cast<Eigen::Index>(width), static_cast<Eigen::Index>(width));
  sums.gradient.setZero(static_cast<Eigen::Index>(width));
  sums.cost = 0;
  for (std::size_t block = 0; block < corners.size(); ++block) {
    const ProjectedBlock& seen = projected[block];
    const Lane ru = seen.u - corners[block].u, rv = seen.v - corners[block].v;
    const Lane rr = ru * ru + rv * rv;
    const Lane w = weights(rr * information, corners[block].present, loss, sums.cost);
    addSix(seen.rowsU, seen.rowsV, w, grams);
    for (std::size_t i = 0; i < 6; ++i) {
      gradients[i] += w * (seen.rowsU[i] * ru + seen.rowsV[i] * rv);
    }
    squares += w * rr;
    counted += (w > 0).cast<double>();
    for (std::size_t extra = 0; extra < extras; ++extra) {
      const auto row = static_cast<Eigen::Index>(6 + extra);
      const auto lanes = [&](std::size_t e) { return &extraRows[2 * (e * corners.size() + block)]; };
      const Lane wu = w * lanes(extra)[0], wv = w * lanes(extra)[1];
      for (std::size_t i = 0; i < 6; ++i) {
        sums.gram(row, static_cast<Eigen::Index>(i)) += (wu * seen.rowsU[i] + wv * seen.rowsV[i]).sum();
      }
      for (std::size_t other = 0; other <= extra; ++other) {
        sums.gram(row, static_cast<Eigen::Index>(6 + other)) += (wu * lanes(other)[0] + wv * lanes(other)[1]).sum();
      }
      sums.gradient[row] += (wu * ru + wv * rv).sum();
    }
  }
  std::size_t next = 0;
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      sums.gram(i, j) = grams[next++].sum();
    }
    sums.gradient[i] = gradients[i].sum();
  }
  sums.gram.triangularView<Eigen::StrictlyUpper>() = sums.gram.transpose();
  sums.squares = squares.sum();
  sums.corners = counted.sum();
}

} // namespace naocal

#include "calibrate/PixelNoise.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace naocal {

namespace {

/// Squares of `residual` (u0, v0, u1, ...) left after the motion in `rows` is fitted, and their degrees of freedom.
struct Scatter {
  double squares = 0, freedom = 0;
  void add(const Eigen::VectorXd& residual, const Eigen::MatrixXd& rows, double share) {
    if (residual.size() <= rows.cols() + 2) {
      return;
    }
    const Eigen::VectorXd left = residual - rows * rows.colPivHouseholderQr().solve(residual);
    squares += share * left.squaredNorm();
    freedom += static_cast<double>(residual.size() - rows.cols());
  }
  std::optional<double> level() const {
    return freedom > 20 ? std::optional{std::sqrt(squares / freedom)} : std::nullopt;
  }
};

/// Differences of residuals over the corners that both sightings show and neither doubts.
void addDifference(const Measurements& measurements, const SightingResidual& a, const SightingResidual& b,
                   Scatter& scatter) {
  const auto& idsA = measurements.pictures[a.picture].sightings[a.sighting].ids;
  const auto& idsB = measurements.pictures[b.picture].sightings[b.sighting].ids;
  std::vector<std::pair<Eigen::Index, Eigen::Index>> common;
  for (std::size_t i = 0; i < idsA.size(); ++i) {
    const auto j = std::find(idsB.begin(), idsB.end(), idsA[i]);
    const auto inA = static_cast<Eigen::Index>(i), inB = static_cast<Eigen::Index>(j - idsB.begin());
    if (j != idsB.end() && a.weight[inA] > 0.5 && b.weight[inB] > 0.5) {
      common.emplace_back(inA, inB);
    }
  }
  Eigen::VectorXd difference(2 * static_cast<Eigen::Index>(common.size()));
  Eigen::MatrixXd rows(difference.size(), 6);
  for (std::size_t i = 0; i < common.size(); ++i) {
    const auto row = 2 * static_cast<Eigen::Index>(i);
    difference.segment<2>(row) = b.residual.col(common[i].second) - a.residual.col(common[i].first);
    rows.middleRows<2>(row) = a.motionRows.middleRows<2>(2 * common[i].first);
  }
  scatter.add(difference, rows, 0.5);
}

} // namespace

std::optional<double> pixelNoiseFromRepeats(const Measurements& measurements,
                                            const std::vector<SightingResidual>& sightings) {
  using Key = std::tuple<std::size_t, std::size_t, std::size_t>; // pose, camera, board
  const std::vector<std::size_t> poseOf = posesOfPictures(measurements);
  std::map<Key, const SightingResidual*> last;
  Scatter scatter;
  for (const SightingResidual& sighting : sightings) {
    const Picture& picture = measurements.pictures[sighting.picture];
    const Key key{poseOf[sighting.picture], picture.camera, picture.sightings[sighting.sighting].view.board()};
    const auto [entry, isFirst] = last.try_emplace(key, &sighting);
    if (!isFirst) {
      addDifference(measurements, *entry->second, sighting, scatter);
      entry->second = &sighting;
    }
  }
  return scatter.level();
}

std::optional<double> pixelNoiseWithinPictures(const std::vector<SightingResidual>& sightings) {
  Scatter scatter;
  for (const SightingResidual& sighting : sightings) {
    std::vector<Eigen::Index> good;
    for (Eigen::Index i = 0; i < sighting.weight.size(); ++i) {
      if (sighting.weight[i] > 0.5) {
        good.push_back(i);
      }
    }
    if (good.size() < 8) {
      continue;
    }
    Eigen::VectorXd residual(2 * static_cast<Eigen::Index>(good.size()));
    Eigen::MatrixXd rows(residual.size(), 6);
    for (std::size_t i = 0; i < good.size(); ++i) {
      residual.segment<2>(2 * static_cast<Eigen::Index>(i)) = sighting.residual.col(good[i]);
      rows.middleRows<2>(2 * static_cast<Eigen::Index>(i)) = sighting.motionRows.middleRows<2>(2 * good[i]);
    }
    scatter.add(residual, rows, 1);
  }
  return scatter.level();
}

} // namespace naocal

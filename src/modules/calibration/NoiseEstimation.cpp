#include "calibration/NoiseEstimation.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace naocal {

namespace {

constexpr double finestCorner = 0.002; // [px]: corners are rounded, and no model of a camera is finer

/// Sum of squares of `residual` (u0, v0, u1, ...) after fitting the motion in `rows`, and its degrees of freedom.
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
    return freedom > 20 ? std::optional{std::max(finestCorner, std::sqrt(squares / freedom))} : std::nullopt;
  }
};

/// Pictures of one pose, camera and board: corners lie at the same place in all of them.
using Cell = std::vector<const BoardResidual*>;

/// Columns of a homography's and a lens's displacement fields at `places` (u0, v0, u1, ... by 12).
Eigen::MatrixXd smoothFields(const Eigen::Matrix2Xd& places, const Eigen::Vector2d& middle) {
  const double reach = std::max(1.0, middle.maxCoeff());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * places.cols(), 12);
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const double x = (places(0, i) - middle.x()) / reach, y = (places(1, i) - middle.y()) / reach, r2 = x * x + y * y;
    rows.row(2 * i) << 1, x, y, 0, 0, 0, x * x, x * y, r2 * x, r2 * r2 * x, 2 * x * y, r2 + 2 * x * x;
    rows.row(2 * i + 1) << 0, 0, 0, 1, x, y, x * y, y * y, r2 * y, r2 * r2 * y, r2 + 2 * y * y, 2 * x * y;
  }
  return rows;
}

/// Sums of squares over cells, as in a one-way analysis of variance.
struct Components {
  double within = 0, withinFreedom = 0, between = 0, betweenFreedom = 0, cells = 0, repeats = 0;

  void add(const Measurements& measurements, const Cell& cell) {
    const auto& ids = measurements.pictures[cell.front()->picture].observations[cell.front()->observation].ids;
    std::vector<std::vector<Eigen::Index>> places; // per common corner: its column in each repeat
    for (const int id : ids) {
      std::vector<Eigen::Index> columns;
      for (const BoardResidual* one : cell) {
        const auto& own = measurements.pictures[one->picture].observations[one->observation].ids;
        const auto found = std::find(own.begin(), own.end(), id);
        const Eigen::Index column = found - own.begin();
        if (found != own.end() && one->weight[column] > 0.5) {
          columns.push_back(column);
        }
      }
      if (columns.size() == cell.size()) {
        places.push_back(std::move(columns));
      }
    }
    constexpr std::size_t fewest = 8;
    if (places.size() < fewest || cell.size() < 2) {
      return;
    }
    const auto corners = static_cast<Eigen::Index>(places.size()), count = static_cast<Eigen::Index>(cell.size());
    Eigen::MatrixXd residuals(2 * corners, count);
    Eigen::Matrix2Xd seen(2, corners);
    for (Eigen::Index i = 0; i < corners; ++i) {
      for (Eigen::Index r = 0; r < count; ++r) {
        const BoardResidual& one = *cell[static_cast<std::size_t>(r)];
        const Eigen::Index column = places[static_cast<std::size_t>(i)][static_cast<std::size_t>(r)];
        residuals.block<2, 1>(2 * i, r) = one.residual.col(column);
        seen.col(i) = one.predicted.col(column);
      }
    }
    const ImageObservation& picture = measurements.pictures[cell.front()->picture];
    const auto fields = smoothFields(seen, picture.nominal.lens().segment<2>(2)).colPivHouseholderQr();
    Eigen::MatrixXd left = fields.householderQ().adjoint() * residuals;
    left = left.bottomRows(left.rows() - fields.rank()).eval();
    const Eigen::VectorXd mean = left.rowwise().mean();
    const auto freedom = static_cast<double>(left.rows());
    within += (left.colwise() - mean).squaredNorm();
    withinFreedom += freedom * static_cast<double>(count - 1);
    between += static_cast<double>(count) * mean.squaredNorm();
    betweenFreedom += freedom;
    repeats += static_cast<double>(count);
    cells += 1;
  }
};

} // namespace

std::optional<PixelNoise> estimatePixelNoiseFromRepeats(const Measurements& measurements,
                                                        const std::vector<BoardResidual>& observations) {
  using Key = std::tuple<std::size_t, std::size_t, std::size_t>; // pose, camera, board
  const std::vector<std::size_t> poseOf = posesOfPictures(measurements);
  std::map<Key, Cell> cells;
  for (const BoardResidual& observation : observations) {
    const ImageObservation& picture = measurements.pictures[observation.picture];
    cells[{poseOf[observation.picture], picture.camera, picture.observations[observation.observation].view.board()}]
        .push_back(&observation);
  }
  Components sums;
  bool rested = false;
  for (const auto& [key, cell] : cells) {
    sums.add(measurements, cell);
    rested |=
        cell.size() > 1 &&
        measurements.pictures[cell.front()->picture].observations[cell.front()->observation].repeats == cell.size();
  }
  constexpr double fewest = 20;
  if (sums.withinFreedom < fewest) {
    return std::nullopt;
  }
  const double anew2 = sums.within / sums.withinFreedom, repeats = sums.repeats / sums.cells;
  const double alike2 = rested ? (sums.between / sums.betweenFreedom - anew2) / repeats : 0;
  return PixelNoise{std::max(finestCorner, std::sqrt(anew2)),
                    std::clamp(std::sqrt(std::max(0.0, alike2)), 0.0, PixelNoise::mostAlike)};
}

std::optional<double> estimatePixelNoiseWithinImages(const std::vector<BoardResidual>& observations) {
  Scatter scatter;
  for (const BoardResidual& observation : observations) {
    std::vector<Eigen::Index> good;
    for (Eigen::Index i = 0; i < observation.weight.size(); ++i) {
      if (observation.weight[i] > 0.5) {
        good.push_back(i);
      }
    }
    if (good.size() < 8) {
      continue;
    }
    Eigen::VectorXd residual(2 * static_cast<Eigen::Index>(good.size()));
    Eigen::MatrixXd rows(residual.size(), 6);
    for (std::size_t i = 0; i < good.size(); ++i) {
      residual.segment<2>(2 * static_cast<Eigen::Index>(i)) = observation.residual.col(good[i]);
      rows.middleRows<2>(2 * static_cast<Eigen::Index>(i)) = observation.motionRows.middleRows<2>(2 * good[i]);
    }
    scatter.add(residual, rows, 1);
  }
  return scatter.level();
}

} // namespace naocal

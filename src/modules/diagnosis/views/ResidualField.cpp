#include "diagnosis/views/ResidualField.hpp"

#include "estimation/DriverState.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace naocal {

namespace {

constexpr int cellsAcross = 12, cellsDown = 9; // per picture
constexpr std::size_t fewest = 5;              // corners of a displayed cell
constexpr double trusted = 0.7;                // loss weight from which a corner counts

/// The sightings of one picture, without those behind the camera.
using Sightings = std::vector<const BoardResidual*>;
using CellPlace = std::array<std::size_t, 3>; // of a cell: camera, column, row

/// Sums over the corners of a cell.
struct CellSums {
  ResidualField::Cell cell;
  double squares = 0, worst = 0;

  void add(const Eigen::Vector2d& seen, const Eigen::Vector2d& error, std::size_t picture) {
    cell.u += seen.x();
    cell.v += seen.y();
    cell.du += error.x();
    cell.dv += error.y();
    squares += error.squaredNorm();
    ++cell.corners;
    if (error.norm() > worst) {
      worst = error.norm();
      cell.worstPicture = picture;
    }
  }

  ResidualField::Cell mean() const {
    ResidualField::Cell result = cell;
    const auto count = static_cast<double>(cell.corners);
    for (double* sum : {&result.u, &result.v, &result.du, &result.dv}) {
      *sum /= count;
    }
    const double spread = squares / count - result.du * result.du - result.dv * result.dv;
    result.sigma = std::sqrt(std::max(0.0, spread / 2 / (count - 1)));
    return result;
  }
};

/// Number of trusted corners. With three, the picture's motion fits everything.
double trustedCorners(const Sightings& picture) {
  double count = 0;
  for (const BoardResidual* sighting : picture) {
    count += static_cast<double>((sighting->weight.array() >= trusted).count());
  }
  return count;
}

/// Motion of the picture that explains most of its residuals.
Eigen::Matrix<double, 6, 1> motionOf(const Sightings& picture) {
  Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
  for (const BoardResidual* sighting : picture) {
    for (Eigen::Index i = 0; i < sighting->residual.cols(); ++i) {
      const auto corner = sighting->motionRows.middleRows<2>(2 * i);
      gram += sighting->weight[i] * corner.transpose() * corner;
      gradient += sighting->weight[i] * corner.transpose() * sighting->residual.col(i);
    }
  }
  return gram.ldlt().solve(gradient);
}

/// Predicted - measured of each corner, with the picture's motion removed.
Eigen::Matrix2Xd removeMotion(const BoardResidual& sighting, const Eigen::Matrix<double, 6, 1>& motion) {
  const Eigen::VectorXd moved = sighting.motionRows * motion;
  return moved.reshaped(2, sighting.residual.cols()) - sighting.residual;
}

std::size_t part(double x, int size, int parts) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(x / size * parts), 0, parts - 1));
}

/// Adds a sighting's trusted corners to their cells; returns their number and sum of squares [px^2].
std::pair<double, double> addCorners(const BoardResidual& sighting, const Eigen::Matrix2Xd& errors, std::size_t camera,
                                     const CameraIntrinsics& lens, std::map<CellPlace, CellSums>& cells) {
  double count = 0, squares = 0;
  for (Eigen::Index i = 0; i < errors.cols(); ++i) {
    if (sighting.weight[i] >= trusted) {
      const Eigen::Vector2d seen = sighting.predicted.col(i) + sighting.residual.col(i);
      cells[{camera, part(seen.x(), lens.width, cellsAcross), part(seen.y(), lens.height, cellsDown)}].add(
          seen, errors.col(i), sighting.picture);
      squares += errors.col(i).squaredNorm();
      ++count;
    }
  }
  return {count, squares};
}

} // namespace

ResidualField computeResidualField(const FittedModel& fitted) {
  std::map<std::size_t, Sightings> byPicture;
  for (const BoardResidual& sighting : fitted.fit.sightings) {
    if (sighting.residual.allFinite()) {
      byPicture[sighting.picture].push_back(&sighting);
    }
  }
  ResidualField result;
  result.noisePx = fitted.fit.noise.pixel;
  std::map<CellPlace, CellSums> cells;
  for (const auto& [index, sightings] : byPicture) {
    const double all = trustedCorners(sightings);
    if (all <= 3) {
      continue;
    }
    const ImageObservation& picture = fitted.measurements.pictures[index];
    const CaptureSet& set = fitted.measurements.setOf(picture);
    const CameraIntrinsics& lens = set.cameras.at(set.captures[picture.capture].camera);
    const Eigen::Matrix<double, 6, 1> motion = motionOf(sightings);
    const std::vector<PredictedBoard> boards = predictBoards(
        fitted.measurements, picture, predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns));
    for (const BoardResidual* sighting : sightings) {
      const auto [count, squares] = addCorners(*sighting, removeMotion(*sighting, motion), picture.camera, lens, cells);
      if (count > 0) { // the motion takes six degrees of freedom of the picture
        result.boards.push_back({index, picture.sightings[sighting->sighting].view.board(),
                                 boards[sighting->sighting].distance(),
                                 std::sqrt(squares / (2 * count) / (1 - 3 / all))});
      }
    }
  }
  for (const auto& [place, sums] : cells) {
    if (sums.cell.corners >= fewest) {
      result.cells.push_back(sums.mean());
    }
  }
  return result;
}

std::vector<PredictedBoard> predictBoards(const Measurements& measurements, const ImageObservation& picture,
                                          const ModelState& belief) {
  const Robot& robot = measurements.robot;
  std::vector<PredictedBoard> result;
  LinkPoses torsoFromLink(robot.links.size());
  ProjectedBlocks projected;
  for (const BoardObservation& sighting : picture.sightings) {
    forwardKinematics(robot, belief, sighting.view.links(), torsoFromLink);
    CameraFrames attitude = sighting.view.cameraFrames(robot, belief, torsoFromLink);
    if (belief.rowTime() != 0) {
      sighting.view.setDrift(robot, belief, torsoFromLink, picture.instant.velocity, attitude);
    }
    PredictedBoard& board = result.emplace_back();
    board.opticalFromBoard = attitude.opticalFromBoard;
    board.corners.setConstant(2, eigenIndex(sighting.ids.size()), std::numeric_limits<double>::quiet_NaN());
    if (sighting.view.project(attitude, belief, sighting.corners, projected)) {
      for (Eigen::Index i = 0; i < board.corners.cols(); ++i) {
        const ProjectedBlock& block = projected[static_cast<std::size_t>(i / 4)];
        board.corners.col(i) << block.u[i % 4], block.v[i % 4];
      }
    }
  }
  return result;
}

} // namespace naocal

#include "diagnosis/views/ResidualField.hpp"

#include "calibration/Fit.hpp"
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

/// The observations of one picture, without those behind the camera.
using Observations = std::vector<const BoardResidual*>;
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

/// Number of corners that are no outliers. With three, the picture's motion fits everything.
double trustedCorners(const Observations& picture) {
  double count = 0;
  for (const BoardResidual* observation : picture) {
    count += static_cast<double>((observation->weight.array() >= outlierWeight).count());
  }
  return count;
}

/// Motion of the picture that explains most of its residuals.
Eigen::Matrix<double, 6, 1> motionOf(const Observations& picture) {
  Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
  for (const BoardResidual* observation : picture) {
    for (Eigen::Index i = 0; i < observation->residual.cols(); ++i) {
      const auto corner = observation->motionRows.middleRows<2>(2 * i);
      gram += observation->weight[i] * corner.transpose() * corner;
      gradient += observation->weight[i] * corner.transpose() * observation->residual.col(i);
    }
  }
  return gram.ldlt().solve(gradient);
}

/// Predicted - measured of each corner, with the picture's motion removed.
Eigen::Matrix2Xd removeMotion(const BoardResidual& observation, const Eigen::Matrix<double, 6, 1>& motion) {
  const Eigen::VectorXd moved = observation.motionRows * motion;
  return moved.reshaped(2, observation.residual.cols()) - observation.residual;
}

std::size_t part(double x, int size, int parts) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(x / size * parts), 0, parts - 1));
}

/// Adds an observation's corners that are no outliers to their cells; returns their number and sum of squares [px^2].
std::pair<double, double> addCorners(const BoardResidual& observation, const Eigen::Matrix2Xd& errors,
                                     std::size_t camera, const CameraIntrinsics& lens,
                                     std::map<CellPlace, CellSums>& cells) {
  double count = 0, squares = 0;
  for (Eigen::Index i = 0; i < errors.cols(); ++i) {
    if (observation.weight[i] >= outlierWeight) {
      const Eigen::Vector2d seen = observation.predicted.col(i) + observation.residual.col(i);
      cells[{camera, part(seen.x(), lens.width, cellsAcross), part(seen.y(), lens.height, cellsDown)}].add(
          seen, errors.col(i), observation.picture);
      squares += errors.col(i).squaredNorm();
      ++count;
    }
  }
  return {count, squares};
}

} // namespace

ResidualField computeResidualField(const FittedModel& fitted) {
  std::map<std::size_t, Observations> byPicture;
  for (const BoardResidual& observation : fitted.fit.residuals) {
    if (observation.residual.allFinite()) {
      byPicture[observation.picture].push_back(&observation);
    }
  }
  ResidualField result;
  result.noisePx = fitted.fit.noise.pixel;
  std::map<CellPlace, CellSums> cells;
  for (const auto& [index, observations] : byPicture) {
    const double all = trustedCorners(observations);
    if (all <= 3) {
      continue;
    }
    const ImageObservation& picture = fitted.measurements.pictures[index];
    const CaptureSet& set = fitted.measurements.setOf(picture);
    const CameraIntrinsics& lens = set.cameras.at(set.captures[picture.capture].camera);
    const Eigen::Matrix<double, 6, 1> motion = motionOf(observations);
    const std::vector<PredictedBoard> boards = predictBoards(
        fitted.measurements, picture, predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns));
    for (const BoardResidual* observation : observations) {
      const auto [count, squares] =
          addCorners(*observation, removeMotion(*observation, motion), picture.camera, lens, cells);
      if (count > 0) { // the motion takes six degrees of freedom of the picture
        result.boards.push_back({index, picture.observations[observation->observation].view.board(),
                                 boards[observation->observation].distance(),
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
                                          const ModelState& modelState) {
  const Robot& robot = measurements.robot;
  std::vector<PredictedBoard> result;
  LinkPoses torsoFromLink(robot.links.size());
  ProjectedBlocks projected;
  for (const BoardObservation& observation : picture.observations) {
    forwardKinematics(robot, modelState, observation.view.links(), torsoFromLink);
    CameraFrames attitude = observation.view.cameraFrames({robot, modelState, torsoFromLink});
    if (modelState.rowTime() != 0) {
      observation.view.setDrift({robot, modelState, torsoFromLink}, picture.instant.velocity, attitude);
    }
    PredictedBoard& board = result.emplace_back();
    board.opticalFromBoard = attitude.opticalFromBoard;
    board.corners.setConstant(2, eigenIndex(observation.ids.size()), std::numeric_limits<double>::quiet_NaN());
    if (observation.view.project(attitude, modelState, observation.corners, projected)) {
      for (Eigen::Index i = 0; i < board.corners.cols(); ++i) {
        const ProjectedBlock& block = projected[static_cast<std::size_t>(i / 4)];
        board.corners.col(i) << block.u[i % 4], block.v[i % 4];
      }
    }
  }
  return result;
}

} // namespace naocal

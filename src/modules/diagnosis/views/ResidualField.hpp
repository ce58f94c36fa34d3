#pragma once

#include "calibration/Calibration.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// What is left of the corners' errors when each picture may move as a whole: lens, boards and corner detection do it.
struct ResidualField {
  /// The mean over a cell of one camera's picture.
  struct Cell {
    double u = 0, v = 0;          // where its corners were measured, in the mean [px]
    double du = 0, dv = 0;        // predicted - measured, in the mean [px]
    double sigma = 0;             // standard error of either
    std::size_t corners = 0;      // that count
    std::size_t worstPicture = 0; // the picture with the largest error among them
  };
  /// One board in one picture.
  struct Seen {
    std::size_t picture = 0, board = 0;
    double distance = 0; // of the board's origin from the camera [m]
    double rmsPx = 0;    // per axis, freed of what the picture's motion took with it [px]
  };
  double noisePx = 0; // of a corner, per axis
  std::vector<Cell> cells;
  std::vector<Seen> boards;
};

/// Takes the rigid motion (omega, v) of the scene before each camera out of a fit's residuals:
///
///   r - L (L^T W L)^-1 L^T W r,  L = `BoardResidual::motionRows`, W the corners' weights
ResidualField computeResidualField(const FittedModel& fitted);

/// What one picture should show of one board if everything were as believed.
struct PredictedBoard {
  Eigen::Matrix2Xd corners; // [px]; not finite where one would lie behind the camera
  RigidTransform opticalFromBoard;

  /// Of the board's origin from the camera [m].
  double distance() const { return opticalFromBoard.translation.norm(); }
};

/// Of all sightings of a picture, in their order.
std::vector<PredictedBoard> predictBoards(const Measurements& measurements, const ImageObservation& picture,
                                          const ModelState& belief);

} // namespace naocal

#pragma once

#include "calibration/Calibration.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// Corner errors after fitting a rigid motion to each picture: due to lens, boards and corner detection.
struct ResidualField {
  /// Mean over a cell of one camera's picture.
  struct Cell {
    double u = 0, v = 0;          // mean measured position of its corners [px]
    double du = 0, dv = 0;        // mean of predicted - measured [px]
    double sigma = 0;             // standard error of du and of dv [px]
    std::size_t corners = 0;      // number of corners used
    std::size_t worstPicture = 0; // picture with the largest error
  };
  /// One board in one picture.
  struct Seen {
    std::size_t picture = 0, board = 0;
    double distance = 0; // from the camera to the board's origin [m]
    double rmsPx = 0;    // per axis, corrected for the degrees of freedom of the motion [px]
  };
  double noisePx = 0; // noise of a corner, per axis
  std::vector<Cell> cells;
  std::vector<Seen> boards;
};

/// Removes the rigid motion (omega, v) of the scene before each camera from a fit's residuals:
///
///   r - L (L^T W L)^-1 L^T W r,  L = `BoardResidual::motionRows`, W the corners' weights
ResidualField computeResidualField(const FittedModel& fitted);

/// Predicted appearance of one board in one picture.
struct PredictedBoard {
  Eigen::Matrix2Xd corners; // [px]; not finite for corners behind the camera
  RigidTransform opticalFromBoard;

  /// From the camera to the board's origin [m].
  double distance() const { return opticalFromBoard.translation.norm(); }
};

/// For all observations of a picture, in order.
std::vector<PredictedBoard> predictBoards(const Measurements& measurements, const ImageObservation& picture,
                                          const ModelState& modelState);

} // namespace naocal

#pragma once

#include "residuals/NormalEquations.hpp"
#include "residuals/PictureGram.hpp"
#include "residuals/Residuals.hpp"

namespace naocal {

/// What an evaluation works on. Each thread keeps its own: to allocate it anew takes as long as to project the corners.
struct Residuals::Workspace {
  static Workspace& ofThisThread(const Measurements& measurements) {
    static thread_local Workspace work;
    work.boards.resize(measurements.targets.size());
    work.cost = 0;
    return work;
  }

  /// Most boards lie still from picture to picture.
  const RigidTransform& linkFromBoard(std::size_t board) {
    if (boards[board].placement != belief.boardPlacement(board)) {
      boards[board] = {belief.boardPlacement(board), placed(belief.boardPlacement(board))};
    }
    return boards[board].linkFromBoard;
  }

  struct PlacedBoard {
    Eigen::Matrix<double, 6, 1> placement = Eigen::Matrix<double, 6, 1>::Zero();
    RigidTransform linkFromBoard;
  };
  Belief belief{Quantities{0, 0, 0}};
  std::vector<PlacedBoard> boards;
  Posture torsoFromLink;
  ProjectedBlocks projected;
  std::vector<ExtraRow> extraRows;
  PictureGram corners;
  Eigen::MatrixXd motion;
  NormalEquations sums; // of a pose
  double cost = 0;      // sum of rho
};

} // namespace naocal

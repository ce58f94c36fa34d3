#pragma once

#include "residuals/NormalEquations.hpp"
#include "residuals/PictureGram.hpp"
#include "residuals/Residuals.hpp"
#include "residuals/RowEquations.hpp"

#include <utility>

namespace naocal {

/// What an evaluation works on. Each thread keeps its own: to allocate it anew takes as long as to project the corners.
struct Residuals::Workspace {
  static Workspace& ofThisThread(const Measurements& measurements) {
    static thread_local Workspace work;
    work.boards.resize(measurements.targets.size());
    work.cost = 0;
    work.drivenPicture = nullptr;
    return work;
  }

  /// Most boards lie still from picture to picture.
  const RigidTransform& linkFromBoard(std::size_t board) {
    if (boards[board].placement != belief.boardPlacement(board)) {
      boards[board] = {belief.boardPlacement(board), placed(belief.boardPlacement(board))};
    }
    return boards[board].linkFromBoard;
  }

  /// Pictures of one reading share angles, torques and centre of mass.
  void drive(const Measurements& measurements, const Model& model, const Picture& picture,
             const Eigen::VectorXd& unknowns) {
    const Picture* const last = std::exchange(drivenPicture, &picture);
    if (!last || last->instant.q != picture.instant.q || last->instant.supportFoot != picture.instant.supportFoot ||
        picture.instant.supportFoot == SupportFoot::both) {
      driven = drivenAt(measurements, model, picture, unknowns);
      return;
    }
    Instant instant = picture.instant;
    instant.q.swap(driven.instant.q);
    instant.torque.swap(driven.instant.torque);
    instant.torqueGrowth.swap(driven.instant.torqueGrowth);
    instant.com = driven.instant.com;
    driven.instant = std::move(instant);
  }

  /// Adds a group's sums to those of its pose.
  void add(const PictureGram::Square& gram, const PictureGram::Column& gradient, const Eigen::MatrixXd& by,
           const PreparedPicture::Group& group) {
    if (wantsRows) {
      rows.add(gram, gradient, by, group, slopes);
    } else {
      sums.add(gram, gradient, by, group, slopes);
    }
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
  NormalEquations sums; // of a pose,
  RowEquations rows;    // or these
  bool wantsRows = false;
  double cost = 0; // sum of rho
  Driven driven;
  const Picture* drivenPicture = nullptr; // the one that `driven` is of
  PictureSlopes::Scratch scratch;
  std::vector<double> varyingSlopes;
  const double* slopes = nullptr; // values of the picture's slopes
};

} // namespace naocal

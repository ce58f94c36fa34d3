#include "estimation/PictureWorkspace.hpp"

#include <utility>

namespace naocal {

PictureWorkspace& PictureWorkspace::ofThread(const Measurements& measurements) {
  static thread_local PictureWorkspace work;
  work.boards.resize(measurements.targets.size());
  work.cost = 0;
  work.drivenPicture = nullptr;
  return work;
}

const RigidTransform& PictureWorkspace::linkFromBoard(std::size_t board) {
  if (boards[board].placement != modelState.boardPlacement(board)) {
    boards[board] = {modelState.boardPlacement(board), transformFromPlacement(modelState.boardPlacement(board))};
  }
  return boards[board].linkFromBoard;
}

void PictureWorkspace::drive(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                             const Eigen::VectorXd& unknowns) {
  DriverState& driven = scratch.driven;
  const ImageObservation* const last = std::exchange(drivenPicture, &picture);
  const auto standsAsBefore = [&](const RobotSample& before, const RobotSample& now) {
    return before.supportFoot == now.supportFoot && before.supportLink == now.supportLink &&
           before.upInSupport == now.upInSupport && now.supportFoot != SupportFoot::both;
  };
  if (!last || last->instant.q != picture.instant.q || !standsAsBefore(last->instant, picture.instant)) {
    driven = computeDrivers(measurements, model, picture, unknowns);
    return;
  }
  RobotSample instant = picture.instant;
  instant.q.swap(driven.instant.q);
  instant.torque.swap(driven.instant.torque);
  instant.torqueGrowth.swap(driven.instant.torqueGrowth);
  instant.lateralTorque.swap(driven.instant.lateralTorque);
  instant.com = driven.instant.com;
  driven.instant = std::move(instant);
}

void PictureWorkspace::add(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
                           const Eigen::MatrixXd& by, const PreparedImage::Group& group) {
  if (wantsRows) {
    rows.add(gram, gradient, by, group, slopes);
  } else {
    sums.add(gram, gradient, by, group, slopes);
  }
}

} // namespace naocal

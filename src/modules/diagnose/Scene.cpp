#include "diagnose/Scene.hpp"

#include "math/LinearAlgebra.hpp"

#include <limits>

namespace naocal {

std::vector<SceneBoard> scene(const Measurements& measurements, const Picture& picture, const Belief& belief) {
  const Robot& robot = measurements.robot;
  std::vector<SceneBoard> result;
  Posture torsoFromLink(robot.links.size());
  ProjectedBlocks projected;
  for (const Sighting& sighting : picture.sightings) {
    posture(robot, belief, sighting.view.links(), torsoFromLink);
    Attitude attitude = sighting.view.attitude(robot, belief, torsoFromLink);
    if (belief.rowTime() != 0) {
      sighting.view.setDrift(robot, belief, torsoFromLink, picture.instant.velocity, attitude);
    }
    SceneBoard& board = result.emplace_back();
    board.opticalFromBoard = attitude.opticalFromBoard;
    board.corners.setConstant(2, at(sighting.ids.size()), std::numeric_limits<double>::quiet_NaN());
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

#include "poses/Scene.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Balance.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <set>

namespace naocal {

namespace {

/// All corners of a board, to be projected.
CornerBlocks allCorners(const Board& board) {
  BoardCorners all{.board = board.id, .ids = std::vector<int>(board.points.size()), .uv = {}};
  std::iota(all.ids.begin(), all.ids.end(), 0);
  all.uv.assign(board.points.size(), Eigen::Vector2d::Zero());
  return cornerBlocks(board, all);
}

} // namespace

Scene::Scene(const Robot& robot, SupportFoot foot, const std::vector<Board>& boards,
             const std::map<std::string, CameraIntrinsics>& cameras, const SightLimits& limits)
    : robot_{robot}, limits_{limits}, boards_{boards},
      quantities_{robot.joints.size(), robot.lengths.size(), boards.size()}, drawn_{drawnBelief(robot, quantities_)} {
  for (std::size_t board = 0; board < boards_.size(); ++board) {
    const auto& placement = boards_[board].placement;
    if (!placement || boards_[board].link != "floor") {
      throw InputError{fmt::format("board {}: expected a placement on the floor, found none; poses can only be planned "
                                   "for boards whose place is about known",
                                   boards_[board].id)};
    }
    drawn_.boardPlacement(board) << placement->x, placement->y, placement->z, placement->roll, placement->pitch,
        placement->yaw;
  }
  const Sole& support = supportSole(robot, foot);
  if (foot == SupportFoot::both) {
    otherSole_ = View::betweenLinks(robot, quantities_, otherSole(robot, foot).link, support.link);
  }
  for (const auto& [name, lens] : cameras) {
    const auto camera = robot.cameraIndex(name);
    if (!camera) {
      throw InputError{
          fmt::format("camera {}: expected a camera of the drawing of {}, found none of that name", name, robot.model)};
    }
    for (std::size_t board = 0; board < boards_.size(); ++board) {
      outlooks_.push_back(
          {*camera, lens, View{robot, quantities_, *camera, support.link, true, board}, allCorners(boards_[board])});
    }
  }
}

Scene::Projection Scene::projection(const Outlook& outlook, Belief& belief, const Posture& torsoFromLink) const {
  const CameraIntrinsics& lens = outlook.lens;
  const Board& board = boards_[outlook.view.board()];
  belief.lens() << lens.fx, lens.fy, lens.cx, lens.cy,
      Eigen::Map<const Eigen::Matrix<double, 5, 1>>(lens.distortion.data());
  Projection result;
  result.attitude = outlook.view.attitude(robot_, belief, torsoFromLink);
  if (!outlook.view.project(result.attitude, belief, outlook.corners, result.corners)) {
    return result; // partly behind the camera: too near to be of use
  }
  const Eigen::Vector3d cameraInBoard = result.attitude.opticalFromBoard.inverse().translation;
  for (std::size_t corner = 0; corner < board.points.size(); ++corner) {
    const auto lane = at(corner % 4);
    const double u = result.corners[corner / 4].u[lane], v = result.corners[corner / 4].v[lane];
    const Eigen::Vector3d ray = cameraInBoard - board.points[corner];
    const double distance = ray.norm();
    if (u >= limits_.border && u <= lens.width - 1 - limits_.border && v >= limits_.border &&
        v <= lens.height - 1 - limits_.border && distance >= limits_.nearest && distance <= limits_.farthest &&
        ray.z() >= distance * std::sin(limits_.grazing)) {
      result.seen.push_back(static_cast<int>(corner));
    }
  }
  if (result.seen.size() < (limits_.wholeBoards ? board.points.size() : limits_.corners)) {
    result.seen.clear();
  }
  return result;
}

std::vector<std::size_t> Scene::joints() const {
  std::set<std::size_t> motors;
  for (const Outlook& outlook : outlooks_) {
    for (const std::size_t joint : outlook.view.joints()) {
      motors.insert(robot_.joints[joint].motor);
    }
  }
  if (otherSole_) {
    for (const std::size_t joint : otherSole_->joints()) {
      motors.insert(robot_.joints[joint].motor);
    }
  }
  return {motors.begin(), motors.end()};
}

std::vector<Sight> Scene::sights(const Belief& belief, const Posture& torsoFromLink) const {
  std::vector<Sight> sights;
  Belief own = belief; // each camera has its lens
  for (const Outlook& outlook : outlooks_) {
    Projection seen = projection(outlook, own, torsoFromLink);
    if (!seen.seen.empty()) {
      sights.push_back({robot_.cameras[outlook.camera].name, boards_[outlook.view.board()].id, std::move(seen.seen)});
    }
  }
  return sights;
}

} // namespace naocal

#include "poses/candidates/PlanningScene.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "measurements/FloorContact.hpp"
#include "robot/Balance.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <set>

namespace naocal {

namespace {

/// All corners of a board, for projection.
CornerBlocks allCorners(const Board& board) {
  BoardCorners all{.board = board.id, .ids = std::vector<int>(board.points.size()), .uv = {}};
  std::iota(all.ids.begin(), all.ids.end(), 0);
  all.uv.assign(board.points.size(), Eigen::Vector2d::Zero());
  return packCorners(board, all);
}

/// Information of the visible corners about the 6-D motion of the image.
Eigen::Matrix<double, 6, 6> ofMotion(const ProjectedBlocks& corners, const std::vector<int>& seen) {
  Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
  for (const int corner : seen) {
    const ProjectedBlock& block = corners[static_cast<std::size_t>(corner / 4)];
    Eigen::Matrix<double, 6, 2> rows;
    for (int i = 0; i < 6; ++i) {
      rows.row(i) << block.rowsU[i][corner % 4], block.rowsV[i][corner % 4];
    }
    sum += rows * rows.transpose();
  }
  return sum;
}

} // namespace

PlanningScene::PlanningScene(const Robot& robot, SupportFoot foot, const std::vector<Board>& boards,
                             const std::map<std::string, CameraIntrinsics>& cameras, const VisibilityLimits& limits)
    : robot_{robot}, limits_{limits}, boards_{boards},
      quantities_{robot.joints.size(), robot.lengths.size(), boards.size()}, drawn_{naocal::nominalState(robot,
                                                                                                         quantities_)} {
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
    otherSole_ = ObservationChain::betweenLinks(robot, quantities_, otherSole(robot, foot).link, support.link);
  }
  for (const auto& [name, lens] : cameras) {
    const auto camera = robot.cameraIndex(name);
    if (!camera) {
      throw InputError{
          fmt::format("camera {}: expected a camera of the drawing of {}, found none of that name", name, robot.model)};
    }
    for (std::size_t board = 0; board < boards_.size(); ++board) {
      outlooks_.push_back({*camera, lens, ObservationChain{robot, quantities_, *camera, {support.link, true, board}},
                           allCorners(boards_[board])});
    }
  }
}

PlanningScene::Projection PlanningScene::projection(const Outlook& outlook, ModelState& modelState,
                                                    const LinkPoses& torsoFromLink) const {
  const CameraIntrinsics& lens = outlook.lens;
  const Board& board = boards_[outlook.view.board()];
  modelState.lens() << lens.fx, lens.fy, lens.cx, lens.cy,
      Eigen::Map<const Eigen::Matrix<double, 5, 1>>(lens.distortion.data());
  Projection result;
  result.attitude = outlook.view.cameraFrames({robot_, modelState, torsoFromLink});
  if (!outlook.view.project(result.attitude, modelState, outlook.corners, result.corners)) {
    return result; // partly behind the camera: too close to be useful
  }
  const Eigen::Vector3d cameraInBoard = result.attitude.opticalFromBoard.inverse().translation;
  for (std::size_t corner = 0; corner < board.points.size(); ++corner) {
    const auto lane = eigenIndex(corner % 4);
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

std::vector<std::size_t> PlanningScene::joints() const {
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

std::vector<VisibleBoard> PlanningScene::visibleBoards(const ModelState& modelState,
                                                       const LinkPoses& torsoFromLink) const {
  std::vector<VisibleBoard> sights;
  ModelState own = modelState; // `projection` writes each camera's intrinsics into it
  for (const Outlook& outlook : outlooks_) {
    Projection seen = projection(outlook, own, torsoFromLink);
    if (!seen.seen.empty()) {
      sights.push_back({robot_.cameras[outlook.camera].name, boards_[outlook.view.board()].id, std::move(seen.seen)});
    }
  }
  return sights;
}

Eigen::MatrixXd PlanningScene::information(const ModelState& modelState, const LinkPoses& torsoFromLink,
                                           double pixel) const {
  const std::size_t mounts = robot_.joints.size(), boards = mounts + 3 * robot_.cameras.size();
  const auto size = eigenIndex(boards + 3 * boards_.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  ModelState own = modelState;
  for (const Outlook& outlook : outlooks_) {
    const Projection seen = projection(outlook, own, torsoFromLink);
    if (seen.seen.empty()) {
      continue;
    }
    std::vector<std::size_t> quantities, unknowns; // model quantities that move the image, and the unknown of each
    const auto add = [&](std::size_t quantity, std::size_t unknown) {
      quantities.push_back(quantity);
      unknowns.push_back(unknown);
    };
    for (const std::size_t joint : outlook.view.joints()) {
      add(quantities_.angle(joint), robot_.joints[joint].motor);
    }
    const std::size_t board = outlook.view.board();
    for (const std::size_t i : {0, 1, 2}) {
      add(quantities_.mountRotation() + i, mounts + 3 * outlook.camera + i);
      add(quantities_.board(board) + (i < 2 ? i : 5), boards + 3 * board + i);
    }
    Eigen::MatrixXd motion(6, eigenIndex(quantities.size()));
    outlook.view.fillMotionColumns({robot_, own, torsoFromLink}, seen.attitude, quantities, {}, motion);
    const Eigen::MatrixXd ofQuantities =
        motion.transpose() * ofMotion(seen.corners, seen.seen) * motion / (pixel * pixel);
    for (std::size_t a = 0; a < unknowns.size(); ++a) {
      for (std::size_t b = 0; b < unknowns.size(); ++b) {
        information(eigenIndex(unknowns[a]), eigenIndex(unknowns[b])) += ofQuantities(eigenIndex(a), eigenIndex(b));
      }
    }
  }
  if (otherSole_) {
    addFloorContact(modelState, torsoFromLink, information);
  }
  return information;
}

void PlanningScene::addFloorContact(const ModelState& modelState, const LinkPoses& torsoFromLink,
                                    Eigen::MatrixXd& information) const {
  const CameraFrames attitude = otherSole_->pathFrames({robot_, modelState, torsoFromLink});
  const std::vector<std::size_t>& joints = otherSole_->joints();
  std::vector<std::size_t> quantities;
  for (const std::size_t joint : joints) {
    quantities.push_back(quantities_.angle(joint));
  }
  Eigen::MatrixXd motion(6, eigenIndex(joints.size()));
  otherSole_->fillMotionColumns({robot_, modelState, torsoFromLink}, attitude, quantities, {}, motion);
  const Eigen::MatrixXd slopes = floorContactJacobian(attitude.opticalFromWorld.rotation.col(2)) * motion;
  const Eigen::MatrixXd told = slopes.transpose() * slopes;
  for (std::size_t a = 0; a < joints.size(); ++a) {
    for (std::size_t b = 0; b < joints.size(); ++b) {
      information(eigenIndex(robot_.joints[joints[a]].motor), eigenIndex(robot_.joints[joints[b]].motor)) +=
          told(eigenIndex(a), eigenIndex(b));
    }
  }
}

Eigen::MatrixXd PlanningScene::priorInformation() const {
  // Offsets are uniform within 6.5 degrees, camera rotations within 2 degrees; board placements are roughly known.
  const double offset = radians(6.5) / std::sqrt(3.0), mount = radians(2) / std::sqrt(3.0); // [rad]
  constexpr double board = 0.1;                                                             // [m] and [rad]
  const auto offsets = eigenIndex(robot_.joints.size()), mounts = eigenIndex(3 * robot_.cameras.size());
  Eigen::VectorXd sigma = Eigen::VectorXd::Constant(offsets + mounts + eigenIndex(3 * boards_.size()), board);
  sigma.head(offsets).setConstant(offset);
  sigma.segment(offsets, mounts).setConstant(mount);
  return sigma.array().square().inverse().matrix().asDiagonal();
}

} // namespace naocal

#include "writer/Jacobian.hpp"

#include "writer/Layout.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace blind {

namespace {

using Eigen::Index;

constexpr double nudge = 1e-5; // [rad, m]

using View = std::function<Motion(double)>; // cameraFromBoard with one unknown changed by so much

/// Derivative of a sight's corners by whatever moves the board in the camera's frame.
Eigen::VectorXd slope(const Sight& sight, const View& view) {
  Eigen::VectorXd column{2 * static_cast<Index>(sight.ids.size())};
  const Motion before = view(-nudge), after = view(nudge);
  for (std::size_t i = 0; i < sight.ids.size(); ++i) {
    const int id = sight.ids[i];
    const Eigen::Vector3d point{Sheet::square * (id % (Sheet::squaresX - 1) + 1),
                                -Sheet::square * (id / (Sheet::squaresX - 1) + 1), 0};
    column.segment<2>(2 * static_cast<Index>(i)) =
        (seenAt(after * point, {}) - seenAt(before * point, {})) / (2 * nudge);
  }
  return column;
}

FloorPlace moved(FloorPlace place, int coordinate, double by) {
  (coordinate == 0 ? place.x : coordinate == 1 ? place.y : place.yaw) += by;
  return place;
}

} // namespace

Jacobian::Jacobian(const Robot& robot, const Session& session) {
  const Drawing& drawing = *robot.drawing;
  std::map<int, Index> motors;
  for (const Stance& stance : session.stances) {
    for (const int joint : chainOf(drawing, stance.side)) {
      motors.try_emplace(joint, 0);
    }
  }
  Index columns = 0;
  for (auto& [joint, column] : motors) {
    column = columns++;
  }
  const Index cameras = columns, boards = cameras + 6;
  const Index stances = boards + 3 * (static_cast<Index>(session.boards.size()) - 1);
  columns = stances + 3 * static_cast<Index>(session.stances.size());
  Index rows = 0;
  for (const Sight& sight : session.sights) {
    rows += 2 * static_cast<Index>(sight.ids.size());
  }
  placeCount_ = columns - boards;
  unknowns_ = Eigen::MatrixXd::Zero(rows, columns);
  byChain_ = Eigen::MatrixXd::Zero(rows, chainLength);
  priorWeights_ = Eigen::VectorXd::Zero(columns);
  priorWeights_.head(cameras).setConstant(1 / (0.1 * 0.1));
  priorWeights_.segment(cameras, 6).setConstant(1 / (0.05 * 0.05));
  constexpr double anywhere = 10; // [m, rad]
  priorWeights_.tail(placeCount_).setConstant(1 / (anywhere * anywhere));

  const Pictures pictures{robot, session};
  Index row = 0;
  std::pair<int, int> before{-1, -1};
  std::array<std::array<Motion, 2>, chainLength> byJoint; // cameraFromFloor with a joint a step back and forth
  for (const Sight& sight : session.sights) {
    const Index height = 2 * static_cast<Index>(sight.ids.size());
    const Stance& stance = session.stances[session.readings[sight.reading].stance];
    const std::vector<int> chain = chainOf(drawing, stance.side);
    const Eigen::VectorXd& angles = pictures.angles(sight.reading);
    const Motion cameraFromFloor = pictures.cameraFromFloor(sight.reading, sight.camera, angles);
    const FloorPlace& board = session.boards[sight.board];
    const Motion floorFromBoard = onFloor(board);
    if (before != std::pair{sight.reading, sight.camera}) {
      before = {sight.reading, sight.camera};
      for (Index i = 0; i < chainLength; ++i) {
        for (const int way : {0, 1}) {
          Eigen::VectorXd turned = angles;
          turned[chain[i]] += way == 0 ? -nudge : nudge;
          for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
            if (!drawing.joints[joint].drivenBy.empty()) {
              turned[static_cast<Index>(joint)] = turned[drawing.joint(drawing.joints[joint].drivenBy)];
            }
          }
          byJoint[i][way] = pictures.cameraFromFloor(sight.reading, sight.camera, turned);
        }
      }
    }
    const auto rowsOf = [&](Index column) { return unknowns_.col(column).segment(row, height); };
    for (Index i = 0; i < chainLength; ++i) {
      byChain_.col(i).segment(row, height) =
          slope(sight, [&](double by) { return byJoint[i][by > 0 ? 1 : 0] * floorFromBoard; });
      rowsOf(motors.at(chain[i])) = -byChain_.col(i).segment(row, height);
    }
    for (int axis = 0; axis < 3; ++axis) { // the rotations of a mount that is nearly right, one about each axis
      rowsOf(cameras + 3 * sight.camera + axis) = slope(sight, [&](double by) {
        return Motion{turnAbout(Eigen::Vector3d::Unit(axis), -by), Eigen::Vector3d::Zero()} * cameraFromFloor *
               floorFromBoard;
      });
      if (sight.board > 0) {
        rowsOf(boards + 3 * (sight.board - 1) + axis) =
            slope(sight, [&](double by) { return cameraFromFloor * onFloor(moved(board, axis, by)); });
      }
      rowsOf(stances + 3 * session.readings[sight.reading].stance + axis) = slope(sight, [&](double by) {
        return cameraFromFloor * onFloor(stance.place) * onFloor(moved(stance.place, axis, by)).inverse() *
               floorFromBoard;
      });
    }
    row += height;
  }
}

} // namespace blind

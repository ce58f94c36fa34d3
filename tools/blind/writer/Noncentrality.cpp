#include "writer/Noncentrality.hpp"

#include "writer/Design.hpp"
#include "writer/Poses.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace blind {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double nudge = 1e-5; // [rad, m]

using View = std::function<Transform(double)>; // cameraFromBoard with one unknown changed by the argument

/// Derivative of a sight's corners with respect to a motion of the board in the camera frame.
Eigen::VectorXd slope(const BoardSight& sight, const View& view) {
  Eigen::VectorXd column{2 * static_cast<Index>(sight.ids.size())};
  const Transform before = view(-nudge), after = view(nudge);
  for (std::size_t i = 0; i < sight.ids.size(); ++i) {
    const int id = sight.ids[i];
    const Eigen::Vector3d point{Sheet::square * (id % (Sheet::squaresX - 1) + 1),
                                -Sheet::square * (id / (Sheet::squaresX - 1) + 1), 0};
    column.segment<2>(2 * static_cast<Index>(i)) =
        (projectPoint(after * point, {}) - projectPoint(before * point, {})) / (2 * nudge);
  }
  return column;
}

FloorPlace moved(FloorPlace place, int coordinate, double by) {
  (coordinate == 0 ? place.x : coordinate == 1 ? place.y : place.yaw) += by;
  return place;
}

/// Derivatives of all corners with respect to a calibration's unknowns, by central differences on a robot without
/// flaws.
class Jacobian {
public:
  static constexpr Eigen::Index chainLength = 8;

  Jacobian(const Robot& robot, const Session& session);

  /// [px/rad, px/m]: motors in use, three rotations per camera, x, y, yaw of every board except the first, and of every
  /// stance.
  const Eigen::MatrixXd& unknowns() const { return unknowns_; }
  /// Number of placement columns, at the end.
  Eigen::Index placeCount() const { return placeCount_; }
  /// 1 / sigma^2 of the priors: offsets 0.1 rad, camera rotations 0.05 rad, placements practically free.
  const Eigen::VectorXd& priorWeights() const { return priorWeights_; }
  /// [px/rad]: by the true angles of the joints between the reading's sole and the cameras.
  const Eigen::MatrixXd& byChain() const { return byChain_; }

private:
  Eigen::MatrixXd unknowns_, byChain_;
  Eigen::VectorXd priorWeights_;
  Eigen::Index placeCount_ = 0;
};

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
  for (const BoardSight& sight : session.sights) {
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

  const TruePictures pictures{robot, session};
  Index row = 0;
  std::pair<int, int> before{-1, -1};
  std::array<std::array<Transform, 2>, chainLength> byJoint; // cameraFromFloor with one joint moved by -nudge, +nudge
  for (const BoardSight& sight : session.sights) {
    const Index height = 2 * static_cast<Index>(sight.ids.size());
    const Stance& stance = session.stances[session.readings[sight.reading].stance];
    const std::vector<int> chain = chainOf(drawing, stance.side);
    const Eigen::VectorXd& angles = pictures.angles(sight.reading);
    const Transform cameraFromFloor = pictures.cameraFromFloor(sight.reading, sight.camera, angles);
    const FloorPlace& board = session.boards[sight.board];
    const Transform floorFromBoard = floorFromPlace(board);
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
    for (int axis = 0; axis < 3; ++axis) { // small rotations of the mount, one about each axis
      rowsOf(cameras + 3 * sight.camera + axis) = slope(sight, [&](double by) {
        return Transform{rotationAbout(Eigen::Vector3d::Unit(axis), -by), Eigen::Vector3d::Zero()} * cameraFromFloor *
               floorFromBoard;
      });
      if (sight.board > 0) {
        rowsOf(boards + 3 * (sight.board - 1) + axis) =
            slope(sight, [&](double by) { return cameraFromFloor * floorFromPlace(moved(board, axis, by)); });
      }
      rowsOf(stances + 3 * session.readings[sight.reading].stance + axis) = slope(sight, [&](double by) {
        return cameraFromFloor * floorFromPlace(stance.place) *
               floorFromPlace(moved(stance.place, axis, by)).inverse() * floorFromBoard;
      });
    }
    row += height;
  }
}

} // namespace

double noiseFloor(const Robot& robot, const Session& session, const ObservedCorners& seen) {
  Session asRead = session;
  for (Reading& reading : asRead.readings) {
    reading.unread.setZero();
    reading.stuck.setZero();
  }
  Eigen::VectorXd missing = -Noncentrality::stacked(TruePictures{robot, asRead}, asRead);
  Eigen::Index row = 0;
  for (const std::vector<Eigen::Vector2d>& sight : seen) {
    for (const Eigen::Vector2d& corner : sight) {
      missing.segment<2>(row) += corner;
      row += 2;
    }
  }
  const Robot sound = withoutFlaws(robot); // for the derivatives, which flaws hardly affect
  const Jacobian jacobian{sound, asRead};
  const Eigen::MatrixXd places = jacobian.unknowns().rightCols(jacobian.placeCount());
  const Eigen::VectorXd left = missing - places * places.colPivHouseholderQr().solve(missing);
  return std::sqrt(left.squaredNorm() / (0.5 * static_cast<double>(left.size())));
}

Noncentrality::Noncentrality(const Robot& robot, const Session& session, const NoiseRegime& noise) {
  const Jacobian jacobian{robot, session};
  unknowns_ = jacobian.unknowns();

  struct Member {
    std::size_t sight;
    Index row;
  };
  std::map<int, std::vector<Member>> poses;
  Index row = 0;
  for (std::size_t sight = 0; sight < session.sights.size(); ++sight) {
    poses[session.readings[session.sights[sight].reading].pose].push_back({sight, row});
    row += 2 * static_cast<Index>(session.sights[sight].ids.size());
  }
  const double ofApproach = std::hypot(encoderStep / std::sqrt(12.0), noise.stiction / std::sqrt(2.0));
  const double ofPose = noise.stiction / std::sqrt(2.0);
  constexpr Index chain = Jacobian::chainLength;
  for (const auto& [pose, members] : poses) {
    std::map<int, Index> approaches;
    std::map<std::pair<int, int>, Index> pictures;
    for (const Member& member : members) {
      const BoardSight& sight = session.sights[member.sight];
      approaches.try_emplace(session.readings[sight.reading].approachNumber, static_cast<Index>(approaches.size()));
      pictures.try_emplace({sight.reading, sight.camera}, static_cast<Index>(pictures.size()));
    }
    const Index biases = noise.pictureBias > 0 ? 2 * static_cast<Index>(pictures.size()) : 0;
    const Index deflections = chain * (static_cast<Index>(approaches.size()) + (ofPose > 0 ? 1 : 0));
    Index size = 0;
    for (const Member& member : members) {
      size += 2 * static_cast<Index>(session.sights[member.sight].ids.size());
    }
    Block block;
    block.shared = MatrixXd::Zero(size, deflections + biases);
    block.weights.resize(size);
    Index at = 0;
    for (const Member& member : members) {
      const BoardSight& sight = session.sights[member.sight];
      const Index height = 2 * static_cast<Index>(sight.ids.size());
      const auto byJoints = jacobian.byChain().middleRows(member.row, height);
      const Index approach = approaches.at(session.readings[sight.reading].approachNumber);
      block.shared.block(at, chain * approach, height, chain) = ofApproach * byJoints;
      if (ofPose > 0) {
        block.shared.block(at, deflections - chain, height, chain) = ofPose * byJoints;
      }
      for (Index i = 0; i < height; ++i) {
        block.rows.push_back(member.row + i);
        block.weights[at + i] = 1 / (sight.sigma * sight.sigma);
        if (biases > 0) {
          block.shared(at + i, deflections + 2 * pictures.at({sight.reading, sight.camera}) + i % 2) =
              noise.pictureBias;
        }
      }
      at += height;
    }
    block.inner.compute(MatrixXd::Identity(block.shared.cols(), block.shared.cols()) +
                        block.shared.transpose() * block.weights.asDiagonal() * block.shared);
    blocks_.push_back(std::move(block));
  }
  whitenedUnknowns_ = whitened(unknowns_);
  MatrixXd information = unknowns_.transpose() * whitenedUnknowns_;
  information.diagonal() += jacobian.priorWeights();
  information_.compute(information);
}

MatrixXd Noncentrality::whitened(const MatrixXd& columns) const {
  MatrixXd result{columns.rows(), columns.cols()};
  for (const Block& block : blocks_) {
    const MatrixXd weighted = block.weights.asDiagonal() * columns(block.rows, Eigen::all);
    result(block.rows, Eigen::all) =
        weighted - block.weights.asDiagonal() * (block.shared * block.inner.solve(block.shared.transpose() * weighted));
  }
  return result;
}

VectorXd Noncentrality::stacked(const TruePictures& pictures, const Session& session) {
  std::vector<double> values;
  for (const BoardSight& sight : session.sights) {
    for (const Eigen::Vector2d& corner : pictures.corners(sight)) {
      values.push_back(corner.x());
      values.push_back(corner.y());
    }
  }
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

double Noncentrality::knownProduct(const VectorXd& left, const VectorXd& right) const {
  return left.dot(whitened(right).col(0));
}

double Noncentrality::product(const VectorXd& left, const VectorXd& right) const {
  const VectorXd leftPart = whitenedUnknowns_.transpose() * left, rightPart = whitenedUnknowns_.transpose() * right;
  return knownProduct(left, right) - leftPart.dot(information_.solve(rightPart));
}

} // namespace blind

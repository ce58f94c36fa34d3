#include "writer/Noncentrality.hpp"

#include "writer/Design.hpp"
#include "writer/Poses.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

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

/// Number of rows of a sight: two per corner.
Index rowCount(const BoardSight& sight) {
  return 2 * static_cast<Index>(sight.ids.size());
}

/// First columns of the unknowns of each kind.
struct ColumnLayout {
  std::map<int, Index> motors; // column by joint
  Index cameras = 0, boards = 0, stances = 0, count = 0;
};

ColumnLayout layOutColumns(const Drawing& drawing, const Session& session) {
  ColumnLayout layout;
  for (const Stance& stance : session.stances) {
    for (const int joint : chainOf(drawing, stance.side)) {
      layout.motors.try_emplace(joint, 0);
    }
  }
  for (auto& [joint, column] : layout.motors) {
    column = layout.cameras++;
  }
  layout.boards = layout.cameras + 6;
  layout.stances = layout.boards + 3 * (static_cast<Index>(session.boards.size()) - 1);
  layout.count = layout.stances + 3 * static_cast<Index>(session.stances.size());
  return layout;
}

constexpr Index chainLength = 8; // joints between a sole and the cameras

/// cameraFromFloor with one joint of the chain moved by -nudge, +nudge.
using MovedCameras = std::array<std::array<Transform, 2>, chainLength>;

MovedCameras moveJoints(const Drawing& drawing, const TruePictures& pictures, const BoardSight& sight,
                        const std::vector<int>& chain) {
  MovedCameras result;
  for (Index i = 0; i < chainLength; ++i) {
    for (const int way : {0, 1}) {
      Eigen::VectorXd turned = pictures.angles(sight.reading);
      turned[chain[i]] += way == 0 ? -nudge : nudge;
      for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
        if (!drawing.joints[joint].drivenBy.empty()) {
          turned[static_cast<Index>(joint)] = turned[drawing.joint(drawing.joints[joint].drivenBy)];
        }
      }
      result[i][way] = pictures.cameraFromFloor(sight.reading, sight.camera, turned);
    }
  }
  return result;
}

/// Derivatives of all corners with respect to a calibration's unknowns, by central differences on a robot without
/// flaws.
class Jacobian {
public:
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
  struct PlacedSight;
  void setPriorWeights();
  void fillChain(const PlacedSight& placed);
  void fillMount(const PlacedSight& placed);
  void fillPlacements(const PlacedSight& placed);
  /// A sight's rows of one column.
  auto rowsOf(const PlacedSight& placed, Index column);

  ColumnLayout layout_;
  Eigen::MatrixXd unknowns_, byChain_;
  Eigen::VectorXd priorWeights_;
  Eigen::Index placeCount_ = 0;
};

/// A sight with the transforms of its camera and board.
struct Jacobian::PlacedSight {
  const Session& session;
  const BoardSight& sight;
  const std::vector<int>& chain; // joints between sole and camera
  const MovedCameras& byJoint;
  Transform cameraFromFloor, floorFromBoard;
  Index row = 0; // its first row

  const Stance& stance() const { return session.stances[session.readings[sight.reading].stance]; }
};

auto Jacobian::rowsOf(const PlacedSight& placed, Index column) {
  return unknowns_.col(column).segment(placed.row, rowCount(placed.sight));
}

void Jacobian::setPriorWeights() {
  constexpr double anywhere = 10; // [m, rad]
  priorWeights_ = Eigen::VectorXd::Zero(layout_.count);
  priorWeights_.head(layout_.cameras).setConstant(1 / (0.1 * 0.1));
  priorWeights_.segment(layout_.cameras, 6).setConstant(1 / (0.05 * 0.05));
  priorWeights_.tail(placeCount_).setConstant(1 / (anywhere * anywhere));
}

void Jacobian::fillChain(const PlacedSight& placed) {
  for (Index i = 0; i < chainLength; ++i) {
    auto byAngle = byChain_.col(i).segment(placed.row, rowCount(placed.sight));
    byAngle = slope(placed.sight, [&](double by) { return placed.byJoint[i][by > 0 ? 1 : 0] * placed.floorFromBoard; });
    rowsOf(placed, layout_.motors.at(placed.chain[i])) = -byAngle;
  }
}

/// Small rotations of the mount, one about each axis.
void Jacobian::fillMount(const PlacedSight& placed) {
  for (int axis = 0; axis < 3; ++axis) {
    rowsOf(placed, layout_.cameras + 3 * placed.sight.camera + axis) = slope(placed.sight, [&](double by) {
      return Transform{rotationAbout(Eigen::Vector3d::Unit(axis), -by), Eigen::Vector3d::Zero()} *
             placed.cameraFromFloor * placed.floorFromBoard;
    });
  }
}

void Jacobian::fillPlacements(const PlacedSight& placed) {
  const BoardSight& sight = placed.sight;
  const FloorPlace &board = placed.session.boards[sight.board], &stance = placed.stance().place;
  for (int axis = 0; axis < 3; ++axis) {
    if (sight.board > 0) {
      rowsOf(placed, layout_.boards + 3 * (sight.board - 1) + axis) =
          slope(sight, [&](double by) { return placed.cameraFromFloor * floorFromPlace(moved(board, axis, by)); });
    }
    rowsOf(placed, layout_.stances + 3 * placed.session.readings[sight.reading].stance + axis) =
        slope(sight, [&](double by) {
          return placed.cameraFromFloor * floorFromPlace(stance) * floorFromPlace(moved(stance, axis, by)).inverse() *
                 placed.floorFromBoard;
        });
  }
}

Jacobian::Jacobian(const Robot& robot, const Session& session) : layout_{layOutColumns(*robot.drawing, session)} {
  Index rows = 0;
  for (const BoardSight& sight : session.sights) {
    rows += rowCount(sight);
  }
  placeCount_ = layout_.count - layout_.boards;
  unknowns_ = Eigen::MatrixXd::Zero(rows, layout_.count);
  byChain_ = Eigen::MatrixXd::Zero(rows, chainLength);
  setPriorWeights();
  const TruePictures pictures{robot, session};
  Index row = 0;
  std::pair<int, int> before{-1, -1};
  MovedCameras byJoint;
  for (const BoardSight& sight : session.sights) {
    const Stance& stance = session.stances[session.readings[sight.reading].stance];
    const std::vector<int> chain = chainOf(*robot.drawing, stance.side);
    if (before != std::pair{sight.reading, sight.camera}) {
      before = {sight.reading, sight.camera};
      byJoint = moveJoints(*robot.drawing, pictures, sight, chain);
    }
    const PlacedSight placed{session,
                             sight,
                             chain,
                             byJoint,
                             pictures.cameraFromFloor(sight.reading, sight.camera, pictures.angles(sight.reading)),
                             floorFromPlace(session.boards[sight.board]),
                             row};
    fillChain(placed);
    fillMount(placed);
    fillPlacements(placed);
    row += rowCount(sight);
  }
}

/// A sight and its first row.
struct SightRows {
  const BoardSight* sight;
  Index row;
};

/// First columns of `PoseNoise::shared`: by approach, then stiction common to the approaches, then by picture.
struct NoiseColumns {
  std::map<int, Index> approaches;               // number by approach
  std::map<std::pair<int, int>, Index> pictures; // number by (reading, camera)
  Index stiction = 0, biases = 0, count = 0;
};

NoiseColumns layOutNoise(const std::vector<SightRows>& members, const Session& session, const NoiseRegime& noise) {
  NoiseColumns columns;
  for (const SightRows& member : members) {
    const BoardSight& sight = *member.sight;
    columns.approaches.try_emplace(session.readings[sight.reading].approachNumber,
                                   static_cast<Index>(columns.approaches.size()));
    columns.pictures.try_emplace({sight.reading, sight.camera}, static_cast<Index>(columns.pictures.size()));
  }
  columns.stiction = chainLength * static_cast<Index>(columns.approaches.size());
  columns.biases = columns.stiction + (noise.stiction > 0 ? chainLength : 0);
  columns.count = columns.biases + (noise.pictureBias > 0 ? 2 * static_cast<Index>(columns.pictures.size()) : 0);
  return columns;
}

PoseNoise noiseOf(const std::vector<SightRows>& members, const MatrixXd& byChain, const Session& session,
                  const NoiseRegime& noise) {
  const double ofApproach = std::hypot(encoderStep / std::sqrt(12.0), noise.stiction / std::sqrt(2.0));
  const double ofPose = noise.stiction / std::sqrt(2.0);
  const NoiseColumns columns = layOutNoise(members, session, noise);
  Index size = 0;
  for (const SightRows& member : members) {
    size += rowCount(*member.sight);
  }
  PoseNoise result{{}, MatrixXd::Zero(size, columns.count), VectorXd(size)};
  Index at = 0;
  for (const SightRows& member : members) {
    const BoardSight& sight = *member.sight;
    const Index height = rowCount(sight);
    const auto byJoints = byChain.middleRows(member.row, height);
    const Index approach = columns.approaches.at(session.readings[sight.reading].approachNumber);
    result.shared.block(at, chainLength * approach, height, chainLength) = ofApproach * byJoints;
    if (ofPose > 0) {
      result.shared.block(at, columns.stiction, height, chainLength) = ofPose * byJoints;
    }
    for (Index i = 0; i < height; ++i) {
      result.rows.push_back(member.row + i);
      result.weights[at + i] = 1 / (sight.sigma * sight.sigma);
      if (noise.pictureBias > 0) {
        const Index picture = columns.pictures.at({sight.reading, sight.camera});
        result.shared(at + i, columns.biases + 2 * picture + i % 2) = noise.pictureBias;
      }
    }
    at += height;
  }
  return result;
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

namespace {

std::vector<PoseNoise> noiseByPose(const Jacobian& jacobian, const Session& session, const NoiseRegime& noise) {
  std::map<int, std::vector<SightRows>> poses;
  Index row = 0;
  for (const BoardSight& sight : session.sights) {
    poses[session.readings[sight.reading].pose].push_back({&sight, row});
    row += rowCount(sight);
  }
  std::vector<PoseNoise> result;
  for (const auto& [pose, members] : poses) {
    result.push_back(noiseOf(members, jacobian.byChain(), session, noise));
  }
  return result;
}

ProjectedProduct projectedProduct(const Jacobian& jacobian, const Session& session, const NoiseRegime& noise) {
  return {noiseByPose(jacobian, session, noise), jacobian.unknowns(), jacobian.priorWeights()};
}

} // namespace

Noncentrality::Noncentrality(const Robot& robot, const Session& session, const NoiseRegime& noise)
    : ProjectedProduct{projectedProduct(Jacobian{robot, session}, session, noise)} {}

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

} // namespace blind

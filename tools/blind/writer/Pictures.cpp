#include "writer/Pictures.hpp"

#include "writer/Mechanism.hpp"

#include <cmath>
#include <limits>

namespace blind {

namespace {

/// The radius of the sphere on which an arc of this length, measured from the top, falls by `height`: the solution of
/// (1 - cos x) / x = height / arc for x = arc / radius.
double capRadius(double arc, double height) {
  double x = 2 * height / arc;
  for (int round = 0; round < 8; ++round) {
    const double half = std::sin(x / 2);
    x += 2 * (height / arc - 2 * half * half / x); // the left side's slope is nearly 1/2
  }
  return arc / x;
}

} // namespace

Motion onFloor(const FloorPlace& place) {
  return placed(place.x, place.y, place.yaw);
}

Eigen::Vector3d sheetPoint(const BoardFlaws& flaws, double squaresRight, double squaresDown) {
  const double square = Sheet::square * (1 + flaws.scale);
  const Eigen::Vector2d centre{Sheet::squaresX / 2.0 * square, -Sheet::squaresY / 2.0 * square};
  const Eigen::Vector2d flat{squaresRight * square, -squaresDown * square};
  if (flaws.bow == 0) {
    return {flat.x(), flat.y(), 0};
  }
  const Eigen::Vector2d fromCentre = flat - centre;
  const double arc = fromCentre.norm(), rim = centre.norm();
  const double radius = capRadius(rim, flaws.bow);
  const Eigen::Vector2d onCap = centre + fromCentre * (arc > 0 ? radius * std::sin(arc / radius) / arc : 1);
  return {onCap.x(), onCap.y(), radius * (std::cos(arc / radius) - std::cos(rim / radius))};
}

Eigen::Vector2d seenAt(const Eigen::Vector3d& inCamera, const CameraFlaws& flaws) {
  constexpr double nearest = 0.05; // [m]
  if (inCamera.x() < nearest) {
    return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const double x = -inCamera.y() / inCamera.x(), y = -inCamera.z() / inCamera.x();
  const double square = x * x + y * y;
  const double stretch = 1 + square * (flaws.k1 + square * flaws.k2);
  const double bentX = x * stretch + 2 * flaws.p1 * x * y + flaws.p2 * (square + 2 * x * x);
  const double bentY = y * stretch + flaws.p1 * (square + 2 * y * y) + 2 * flaws.p2 * x * y;
  const double focal = Lens::focal * (1 + flaws.focal);
  return {Lens::cx + flaws.principal.x() + focal * bentX, Lens::cy + flaws.principal.y() + focal * bentY};
}

Pictures::Pictures(const Robot& robot, const Session& session)
    : robot_{robot}, session_{session}, skeleton_{*robot.drawing, robot.flaws}, angles_{trueAngles(robot, session,
                                                                                                   skeleton_)} {
  for (std::size_t reading = 0; reading < session.readings.size(); ++reading) {
    angles_[reading] += robot.flaws.delay * session.readings[reading].velocity;
    cameraFromFloor_.push_back({});
    for (int camera = 0; camera < 2; ++camera) {
      cameraFromFloor_.back()[camera] = cameraFromFloor(static_cast<int>(reading), camera, angles_[reading]);
    }
  }
}

Motion Pictures::floorFromBoard(int board, double time) const {
  FloorPlace place = session_.boards[board];
  if (const auto& kick = session_.kickedBoard; kick && kick->which == board && time >= kick->time) {
    place = {place.x + kick->by.x, place.y + kick->by.y, place.yaw + kick->by.yaw};
  }
  const BoardFlaws& flaws = robot_.flaws.boards[board];
  return onFloor(place) * Motion{tipped(flaws.roll, flaws.pitch), Eigen::Vector3d::Zero()};
}

Motion Pictures::cameraFromFloor(int reading, int camera, const Eigen::VectorXd& angles) const {
  const Reading& read = session_.readings[reading];
  const Stance& stance = session_.stances[read.stance];
  const Skeleton::Posture posture = skeleton_.posture(angles);
  const Motion torsoFromSole = skeleton_.torsoFromSole(posture, stance.side);
  const SoleFlaws& sole = robot_.flaws.soles[stance.side];
  Motion floorFromSole = onFloor(stance.place);
  if (const auto& slip = session_.slippedStance; slip && slip->which == read.stance && read.time >= slip->time) {
    floorFromSole = floorFromSole * onFloor(slip->by);
  }
  if (sole.compliance != 0 || sole.roll != 0 || sole.pitch != 0) {
    const Eigen::Vector3d centre = torsoFromSole.inverse() * skeleton_.centreOfMass(posture);
    floorFromSole = floorFromSole * Motion{soleTilt(sole, centre), Eigen::Vector3d::Zero()};
  }
  const CameraFlaws& flaws = robot_.flaws.cameras[camera];
  const Eigen::Vector3d& turns = robot_.mountTurns[camera];
  const double turned = flaws.turning * (read.time - session_.readings.front().time);
  const Eigen::Matrix3d mountTurn =
      turnAbout(Eigen::Vector3d::UnitX(), turns.x()) * turnAbout(Eigen::Vector3d::UnitY(), turns.y()) *
      turnAbout(Eigen::Vector3d::UnitZ(), turns.z()) * turnAbout(Eigen::Vector3d::UnitY(), turned);
  const Motion torsoFromCamera = skeleton_.torsoFromCamera(posture, camera, mountTurn, flaws.shift);
  return (floorFromSole * torsoFromSole.inverse() * torsoFromCamera).inverse();
}

/// Rows are exposed one after the other: the row that a point falls on decides when, and when decides the row.
Eigen::Vector2d Pictures::exposed(const Sight& sight, const Eigen::Vector3d& inFloor) const {
  const CameraFlaws& flaws = robot_.flaws.cameras[sight.camera];
  Eigen::Vector2d seen = seenAt(cameraFromFloor_[sight.reading][sight.camera] * inFloor, flaws);
  for (int round = 0; flaws.rowTime != 0 && round < 3; ++round) {
    const double late = flaws.rowTime * (seen.y() - Lens::cy);
    const Eigen::VectorXd angles = angles_[sight.reading] + late * session_.readings[sight.reading].velocity;
    seen = seenAt(cameraFromFloor(sight.reading, sight.camera, angles) * inFloor, flaws);
  }
  return seen;
}

std::vector<Eigen::Vector2d> Pictures::points(const Sight& sight, const std::vector<Eigen::Vector2d>& inSquares) const {
  const Motion floorFromSheet = floorFromBoard(sight.board, session_.readings[sight.reading].time);
  std::vector<Eigen::Vector2d> seen;
  seen.reserve(inSquares.size());
  for (const Eigen::Vector2d& point : inSquares) {
    seen.push_back(exposed(sight, floorFromSheet * sheetPoint(robot_.flaws.boards[sight.board], point.x(), point.y())));
  }
  return seen;
}

std::vector<Eigen::Vector2d> Pictures::corners(const Sight& sight) const {
  std::vector<Eigen::Vector2d> inSquares;
  inSquares.reserve(sight.ids.size());
  for (const int id : sight.ids) {
    inSquares.emplace_back(id % (Sheet::squaresX - 1) + 1, id / (Sheet::squaresX - 1) + 1);
  }
  return points(sight, inSquares);
}

} // namespace blind

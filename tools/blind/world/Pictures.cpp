#include "world/Pictures.hpp"

#include "world/Mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blind {

namespace {

constexpr int fewestCorners = 6;

/// Corners of a flat board well inside the image, on squares large enough to be detected.
std::vector<int> findableCorners(const Transform& cameraFromFloor, const FloorPlace& board) {
  constexpr double margin = 8, smallestHeight = 9; // [px]
  const Transform cameraFromBoard = cameraFromFloor * floorFromPlace(board);
  std::vector<int> ids;
  for (int id = 0; id < Sheet::corners; ++id) {
    const int column = id % (Sheet::squaresX - 1) + 1, row = id / (Sheet::squaresX - 1) + 1;
    const Eigen::Vector2d seen = projectPoint(cameraFromBoard * sheetPoint({}, column, row), {});
    if (!(seen.x() > margin && seen.x() < LensDistortion::width - margin && seen.y() > margin &&
          seen.y() < LensDistortion::height - margin)) {
      continue;
    }
    const Eigen::Vector2d right = projectPoint(cameraFromBoard * sheetPoint({}, column + 1, row), {}) - seen;
    const Eigen::Vector2d down = projectPoint(cameraFromBoard * sheetPoint({}, column, row + 1), {}) - seen;
    const double area = std::abs(right.x() * down.y() - right.y() * down.x());
    if (area > smallestHeight * std::max(right.norm(), down.norm())) {
      ids.push_back(id);
    }
  }
  return static_cast<int>(ids.size()) < fewestCorners ? std::vector<int>{} : ids;
}

/// Radius of the sphere on which an arc of length `arc` from the top descends by `height`: solves
/// (1 - cos x) / x = height / arc for x = arc / radius.
double capRadius(double arc, double height) {
  double x = 2 * height / arc;
  for (int round = 0; round < 8; ++round) {
    const double half = std::sin(x / 2);
    x += 2 * (height / arc - 2 * half * half / x); // Newton step: the left side's slope is nearly 1/2
  }
  return arc / x;
}

} // namespace

double cornersInView(const Skeleton& skeleton, const Stance& stance, int camera, const std::vector<FloorPlace>& boards,
                     const Eigen::VectorXd& angles) {
  const Skeleton::Posture posture = skeleton.posture(angles);
  const Transform floorFromTorso =
      floorFromPlace(stance.place) * skeleton.torsoFromSole(posture, stance.side).inverse();
  const Transform torsoFromCamera =
      skeleton.torsoFromCamera(posture, camera, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  const Transform cameraFromFloor = (floorFromTorso * torsoFromCamera).inverse();
  std::size_t count = 0;
  for (const FloorPlace& board : boards) {
    count += findableCorners(cameraFromFloor, board).size();
  }
  return static_cast<double>(count);
}

std::vector<BoardSight> findSights(const TruePictures& pictures, const Session& session) {
  std::vector<BoardSight> sights;
  for (int reading = 0; reading < static_cast<int>(session.readings.size()); ++reading) {
    for (int camera = 0; camera < 2; ++camera) {
      const Transform cameraFromFloor = pictures.cameraFromFloor(reading, camera, pictures.angles(reading));
      for (int board = 0; board < static_cast<int>(session.boards.size()); ++board) {
        std::vector<int> ids = findableCorners(cameraFromFloor, session.boards[board]);
        if (!ids.empty()) {
          sights.push_back({reading, camera, board, std::move(ids), 0});
        }
      }
    }
  }
  return sights;
}

double slantFactor(const TruePictures& pictures, const Session& session, const BoardSight& sight) {
  const Transform cameraFromBoard =
      pictures.cameraFromFloor(sight.reading, sight.camera, pictures.angles(sight.reading)) *
      pictures.floorFromBoard(sight.board, session.readings[sight.reading].time);
  const Eigen::Vector3d middle = cameraFromBoard * sheetPoint({}, Sheet::squaresX / 2.0, Sheet::squaresY / 2.0);
  const double cosine = std::abs(middle.normalized().dot(cameraFromBoard.turn.col(2)));
  return std::sqrt((1 + 1 / (cosine * cosine)) / 2);
}

Transform floorFromPlace(const FloorPlace& place) {
  return floorTransform(place.x, place.y, place.yaw);
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

Eigen::Vector2d projectPoint(const Eigen::Vector3d& inCamera, const CameraFlaws& flaws) {
  constexpr double nearest = 0.05; // [m]
  if (inCamera.x() < nearest) {
    return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const double x = -inCamera.y() / inCamera.x(), y = -inCamera.z() / inCamera.x();
  const double square = x * x + y * y;
  const double stretch = 1 + square * (flaws.k1 + square * flaws.k2);
  const double bentX = x * stretch + 2 * flaws.p1 * x * y + flaws.p2 * (square + 2 * x * x);
  const double bentY = y * stretch + flaws.p1 * (square + 2 * y * y) + 2 * flaws.p2 * x * y;
  const double focal = LensDistortion::focal * (1 + flaws.focal);
  return {LensDistortion::cx + flaws.principal.x() + focal * bentX,
          LensDistortion::cy + flaws.principal.y() + focal * bentY};
}

TruePictures::TruePictures(const Robot& robot, const Session& session)
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

Transform TruePictures::floorFromBoard(int board, double time) const {
  FloorPlace place = session_.boards[board];
  if (const auto& kick = session_.kickedBoard; kick && kick->which == board && time >= kick->time) {
    place = {place.x + kick->by.x, place.y + kick->by.y, place.yaw + kick->by.yaw};
  }
  const BoardFlaws& flaws = robot_.flaws.boards[board];
  return floorFromPlace(place) * Transform{tiltRotation(flaws.roll, flaws.pitch), Eigen::Vector3d::Zero()};
}

Transform TruePictures::cameraFromFloor(int reading, int camera, const Eigen::VectorXd& angles) const {
  const Reading& read = session_.readings[reading];
  const Stance& stance = session_.stances[read.stance];
  const Skeleton::Posture posture = skeleton_.posture(angles);
  const Transform torsoFromSole = skeleton_.torsoFromSole(posture, stance.side);
  const SoleFlaws& sole = robot_.flaws.soles[stance.side];
  Transform floorFromSole = floorFromPlace(stance.place);
  if (const auto& slip = session_.slippedStance; slip && slip->which == read.stance && read.time >= slip->time) {
    floorFromSole = floorFromSole * floorFromPlace(slip->by);
  }
  if (sole.compliance != 0 || sole.roll != 0 || sole.pitch != 0) {
    const Eigen::Vector3d centre = torsoFromSole.inverse() * skeleton_.centreOfMass(posture);
    floorFromSole = floorFromSole * Transform{soleTilt(sole, centre), Eigen::Vector3d::Zero()};
  }
  const CameraFlaws& flaws = robot_.flaws.cameras[camera];
  const Eigen::Vector3d& turns = robot_.mountTurns[camera];
  const double turned = flaws.turning * (read.time - session_.readings.front().time);
  const Eigen::Matrix3d mountTurn =
      rotationAbout(Eigen::Vector3d::UnitX(), turns.x()) * rotationAbout(Eigen::Vector3d::UnitY(), turns.y()) *
      rotationAbout(Eigen::Vector3d::UnitZ(), turns.z()) * rotationAbout(Eigen::Vector3d::UnitY(), turned);
  const Transform torsoFromCamera = skeleton_.torsoFromCamera(posture, camera, mountTurn, flaws.shift);
  return (floorFromSole * torsoFromSole.inverse() * torsoFromCamera).inverse();
}

/// Rolling shutter: the row of a point determines its exposure time and vice versa (fixed-point iteration).
Eigen::Vector2d TruePictures::exposed(const BoardSight& sight, const Eigen::Vector3d& inFloor) const {
  const CameraFlaws& flaws = robot_.flaws.cameras[sight.camera];
  Eigen::Vector2d seen = projectPoint(cameraFromFloor_[sight.reading][sight.camera] * inFloor, flaws);
  for (int round = 0; flaws.rowTime != 0 && round < 3; ++round) {
    const double late = flaws.rowTime * (seen.y() - LensDistortion::cy);
    const Eigen::VectorXd angles = angles_[sight.reading] + late * session_.readings[sight.reading].velocity;
    seen = projectPoint(cameraFromFloor(sight.reading, sight.camera, angles) * inFloor, flaws);
  }
  return seen;
}

std::vector<Eigen::Vector2d> TruePictures::points(const BoardSight& sight,
                                                  const std::vector<Eigen::Vector2d>& inSquares) const {
  const Transform floorFromSheet = floorFromBoard(sight.board, session_.readings[sight.reading].time);
  std::vector<Eigen::Vector2d> seen;
  seen.reserve(inSquares.size());
  for (const Eigen::Vector2d& point : inSquares) {
    seen.push_back(exposed(sight, floorFromSheet * sheetPoint(robot_.flaws.boards[sight.board], point.x(), point.y())));
  }
  return seen;
}

std::vector<Eigen::Vector2d> TruePictures::corners(const BoardSight& sight) const {
  std::vector<Eigen::Vector2d> inSquares;
  inSquares.reserve(sight.ids.size());
  for (const int id : sight.ids) {
    inSquares.emplace_back(id % (Sheet::squaresX - 1) + 1, id / (Sheet::squaresX - 1) + 1);
  }
  return points(sight, inSquares);
}

} // namespace blind

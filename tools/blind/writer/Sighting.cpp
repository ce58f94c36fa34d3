#include "writer/Sighting.hpp"

#include <algorithm>
#include <cmath>

namespace blind {

namespace {

constexpr int fewestCorners = 6;

/// The corners of a flat board that lie well inside the picture, if its squares are large enough to be told apart.
std::vector<int> findableCorners(const Motion& cameraFromFloor, const FloorPlace& board) {
  constexpr double margin = 8, smallestHeight = 9; // [px]
  const Motion cameraFromBoard = cameraFromFloor * onFloor(board);
  std::vector<int> ids;
  for (int id = 0; id < Sheet::corners; ++id) {
    const int column = id % (Sheet::squaresX - 1) + 1, row = id / (Sheet::squaresX - 1) + 1;
    const Eigen::Vector2d seen = seenAt(cameraFromBoard * sheetPoint({}, column, row), {});
    if (!(seen.x() > margin && seen.x() < Lens::width - margin && seen.y() > margin &&
          seen.y() < Lens::height - margin)) {
      continue;
    }
    const Eigen::Vector2d right = seenAt(cameraFromBoard * sheetPoint({}, column + 1, row), {}) - seen;
    const Eigen::Vector2d down = seenAt(cameraFromBoard * sheetPoint({}, column, row + 1), {}) - seen;
    const double area = std::abs(right.x() * down.y() - right.y() * down.x());
    if (area > smallestHeight * std::max(right.norm(), down.norm())) {
      ids.push_back(id);
    }
  }
  return static_cast<int>(ids.size()) < fewestCorners ? std::vector<int>{} : ids;
}

} // namespace

double cornersInView(const Skeleton& skeleton, const Stance& stance, int camera, const std::vector<FloorPlace>& boards,
                     const Eigen::VectorXd& angles) {
  const Skeleton::Posture posture = skeleton.posture(angles);
  const Motion floorFromTorso = onFloor(stance.place) * skeleton.torsoFromSole(posture, stance.side).inverse();
  const Motion torsoFromCamera =
      skeleton.torsoFromCamera(posture, camera, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  const Motion cameraFromFloor = (floorFromTorso * torsoFromCamera).inverse();
  std::size_t count = 0;
  for (const FloorPlace& board : boards) {
    count += findableCorners(cameraFromFloor, board).size();
  }
  return static_cast<double>(count);
}

std::vector<Sight> allSights(const Pictures& pictures, const Session& session) {
  std::vector<Sight> sights;
  for (int reading = 0; reading < static_cast<int>(session.readings.size()); ++reading) {
    for (int camera = 0; camera < 2; ++camera) {
      const Motion cameraFromFloor = pictures.cameraFromFloor(reading, camera, pictures.angles(reading));
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

double slantFactor(const Pictures& pictures, const Session& session, const Sight& sight) {
  const Motion cameraFromBoard = pictures.cameraFromFloor(sight.reading, sight.camera, pictures.angles(sight.reading)) *
                                 pictures.floorFromBoard(sight.board, session.readings[sight.reading].time);
  const Eigen::Vector3d middle = cameraFromBoard * sheetPoint({}, Sheet::squaresX / 2.0, Sheet::squaresY / 2.0);
  const double cosine = std::abs(middle.normalized().dot(cameraFromBoard.turn.col(2)));
  return std::sqrt((1 + 1 / (cosine * cosine)) / 2);
}

} // namespace blind

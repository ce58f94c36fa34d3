#include "simulation/SimulationPlan.hpp"

namespace naocal {

std::map<std::string, CameraIntrinsics> nominalCameras(int width, int height) {
  const double focalLength = 598.0 / 640 * width; // [px]
  const CameraIntrinsics camera{width, height, focalLength, focalLength, width / 2.0, height / 2.0, {}};
  return {{"top", camera}, {"bottom", camera}};
}

std::vector<Board> defaultBoards() {
  struct Spot {
    const char* id;
    Eigen::Vector2d centre; // [m]
    double yaw;             // [rad]
  };
  const std::vector<Spot> spots{
      {"A", {0.62, 0}, 0}, {"B", {0.75, 0.75}, 0.45}, {"C", {0.58, -0.72}, -0.45}, {"D", {1.32, 0.03}, 0.1}};
  std::vector<Board> boards;
  for (const Spot& spot : spots) {
    CharucoPattern pattern;
    const int markers = pattern.squaresX * pattern.squaresY / 2;
    pattern.firstMarkerId = static_cast<int>(boards.size()) * markers;
    Board board;
    board.id = spot.id;
    board.pattern = pattern;
    board.points = innerCorners(pattern);
    const Eigen::Vector2d corner = // top left corner of the sheet, relative to its centre
        Eigen::Rotation2Dd{spot.yaw} *
        (pattern.squareLength / 2 * Eigen::Vector2d{-pattern.squaresX, pattern.squaresY});
    board.placement = Placement{spot.centre.x() + corner.x(), spot.centre.y() + corner.y(), 0, 0, 0, spot.yaw};
    boards.push_back(board);
  }
  return boards;
}

} // namespace naocal

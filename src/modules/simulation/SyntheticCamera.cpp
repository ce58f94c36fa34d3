#include "simulation/SyntheticCamera.hpp"

#include <Eigen/SVD>

namespace naocal {

Eigen::Isometry3d isometryFromPlacement(const Placement& placement) {
  return Eigen::Translation3d{placement.x, placement.y, placement.z} *
         Eigen::AngleAxisd{placement.yaw, Eigen::Vector3d::UnitZ()} *
         Eigen::AngleAxisd{placement.pitch, Eigen::Vector3d::UnitY()} *
         Eigen::AngleAxisd{placement.roll, Eigen::Vector3d::UnitX()} * Eigen::Isometry3d::Identity();
}

std::optional<Eigen::Vector2d> projectPoint(const CameraIntrinsics& camera, const Eigen::Vector3d& pointInCamera) {
  constexpr double nearest = 0.01; // [m]
  if (pointInCamera.x() < nearest) {
    return std::nullopt;
  }
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  const double x = -pointInCamera.y() / pointInCamera.x();
  const double y = -pointInCamera.z() / pointInCamera.x();
  const double r2 = x * x + y * y;
  if (1 + r2 * (3 * k1 + r2 * (5 * k2 + r2 * 7 * k3)) <= 0) {
    return std::nullopt;
  }
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return Eigen::Vector2d{camera.fx * (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)) + camera.cx,
                         camera.fy * (y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y) + camera.cy};
}

namespace {

/// The smaller extent of a square at `point` in the image [px]; 0 if not in view.
double squareHeight(const CameraIntrinsics& camera, const Eigen::Isometry3d& cameraFromBoard,
                    const Eigen::Vector3d& point, double squareLength) {
  const auto middle = projectPoint(camera, cameraFromBoard * point);
  const auto right = projectPoint(camera, cameraFromBoard * (point + squareLength * Eigen::Vector3d::UnitX()));
  const auto up = projectPoint(camera, cameraFromBoard * (point + squareLength * Eigen::Vector3d::UnitY()));
  if (!middle || !right || !up) {
    return 0;
  }
  const Eigen::Matrix2d square = (Eigen::Matrix2d{} << *right - *middle, *up - *middle).finished();
  return square.jacobiSvd().singularValues()[1];
}

} // namespace

BoardCorners visibleCorners(const CameraIntrinsics& camera, const Board& board,
                            const Eigen::Isometry3d& cameraFromBoard) {
  constexpr double margin = 3; // neighbourhood needed to detect a corner [px]
  constexpr std::size_t fewest = 6;
  BoardCorners seen{board.id, {}, {}};
  const Eigen::Isometry3d boardFromCamera = cameraFromBoard.inverse();
  if (boardFromCamera.translation().z() <= 0) { // seen from behind
    return seen;
  }
  const double squareLength = board.pattern ? board.pattern->squareLength : 0;
  for (std::size_t id = 0; id < board.points.size(); ++id) {
    const auto at = projectPoint(camera, cameraFromBoard * board.points[id]);
    const bool inside = at && at->x() >= margin && at->y() >= margin && at->x() <= camera.width - 1 - margin &&
                        at->y() <= camera.height - 1 - margin;
    if (inside && squareHeight(camera, cameraFromBoard, board.points[id], squareLength) >= smallestSquare) {
      seen.ids.push_back(static_cast<int>(id));
      seen.uv.push_back(*at);
    }
  }
  return seen.ids.size() >= fewest ? seen : BoardCorners{board.id, {}, {}};
}

} // namespace naocal

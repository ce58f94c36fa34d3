#pragma once

#include "world/Session.hpp"
#include "world/Skeleton.hpp"

namespace blind {

/// Pose of an object on the floor in the floor frame.
Transform floorFromPlace(const FloorPlace& place);

/// A corner or another point of the sheet, given in squares from its top left outer corner (x right, y down), in the
/// board frame [m]: the sheet is bent to a cap of constant curvature that preserves radial lengths.
Eigen::Vector3d sheetPoint(const BoardFlaws& flaws, double squaresRight, double squaresDown);

/// Projection of a point in the camera frame (x forward, y left, z up) [px]; NaN behind the camera.
Eigen::Vector2d projectPoint(const Eigen::Vector3d& inCamera, const CameraFlaws& flaws);

/// Noiseless observations of a session by the robot's cameras.
class TruePictures {
public:
  TruePictures(const Robot& robot, const Session& session);

  std::vector<Eigen::Vector2d> corners(const BoardSight& sight) const;
  /// Points of a board, given in squares.
  std::vector<Eigen::Vector2d> points(const BoardSight& sight, const std::vector<Eigen::Vector2d>& inSquares) const;
  /// Pose of a board at a time.
  Transform floorFromBoard(int board, double time) const;
  /// Camera pose at the reading's time, for given angles.
  Transform cameraFromFloor(int reading, int camera, const Eigen::VectorXd& angles) const;
  const Eigen::VectorXd& angles(int reading) const { return angles_[reading]; }
  const Skeleton& skeleton() const { return skeleton_; }

private:
  Eigen::Vector2d exposed(const BoardSight& sight, const Eigen::Vector3d& inFloor) const;

  const Robot& robot_;
  const Session& session_;
  Skeleton skeleton_;
  std::vector<Eigen::VectorXd> angles_; // per reading, at mid-exposure
  std::vector<std::array<Transform, 2>> cameraFromFloor_;
};

/// Number of corners that a detector would find.
double cornersInView(const Skeleton& skeleton, const Stance& stance, int camera, const std::vector<FloorPlace>& boards,
                     const Eigen::VectorXd& angles);

/// All boards in all images, with the corners that a detector would find.
std::vector<BoardSight> findSights(const TruePictures& pictures, const Session& session);

/// Noise factor for slanted boards: sqrt((1 + 1 / cosine^2) / 2), cosine of the angle to the board's normal.
double slantFactor(const TruePictures& pictures, const Session& session, const BoardSight& sight);

} // namespace blind

#pragma once

#include "writer/Session.hpp"
#include "writer/Skeleton.hpp"

namespace blind {

/// The frame of something that lies on the floor, in the floor's.
Transform floorFromPlace(const FloorPlace& place);

/// A corner, or any point of the sheet given in squares from its top left outer corner (x right, y down), in the
/// board's frame: the printed sheet bent to a cap of constant curvature whose radii keep their length [m].
Eigen::Vector3d sheetPoint(const BoardFlaws& flaws, double squaresRight, double squaresDown);

/// Where a point of the camera's frame (x forward, y left, z up) is seen [px]; NaN behind the camera.
Eigen::Vector2d projectPoint(const Eigen::Vector3d& inCamera, const CameraFlaws& flaws);

/// What a robot's cameras see during a session, without noise.
class TruePictures {
public:
  TruePictures(const Robot& robot, const Session& session);

  std::vector<Eigen::Vector2d> corners(const BoardSight& sight) const;
  /// Any points of a board, given in squares.
  std::vector<Eigen::Vector2d> points(const BoardSight& sight, const std::vector<Eigen::Vector2d>& inSquares) const;
  /// Of a board at a reading's time.
  Transform floorFromBoard(int board, double time) const;
  /// At the reading's time, the angles given.
  Transform cameraFromFloor(int reading, int camera, const Eigen::VectorXd& angles) const;
  const Eigen::VectorXd& angles(int reading) const { return angles_[reading]; }
  const Skeleton& skeleton() const { return skeleton_; }

private:
  Eigen::Vector2d exposed(const BoardSight& sight, const Eigen::Vector3d& inFloor) const;

  const Robot& robot_;
  const Session& session_;
  Skeleton skeleton_;
  std::vector<Eigen::VectorXd> angles_; // by reading, at the middle of the exposure
  std::vector<std::array<Transform, 2>> cameraFromFloor_;
};

/// How many corners a camera would find.
double cornersInView(const Skeleton& skeleton, const Stance& stance, int camera, const std::vector<FloorPlace>& boards,
                     const Eigen::VectorXd& angles);

/// Every board in every picture, with the corners that a detector would find there.
std::vector<BoardSight> findSights(const TruePictures& pictures, const Session& session);

/// How much worse corners are for the board's slant: sqrt((1 + 1 / cosine^2) / 2) of the angle to its normal.
double slantFactor(const TruePictures& pictures, const Session& session, const BoardSight& sight);

} // namespace blind

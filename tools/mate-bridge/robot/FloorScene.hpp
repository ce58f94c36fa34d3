#pragma once

#include "data/Capture.hpp"
#include "math/RigidTransform.hpp"
#include "robot/Robot.hpp"

#include <Eigen/Core>
#include <array>
#include <deque>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Live calibration of a camera.
struct LiveCamera {
  CameraIntrinsics intrinsics;
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero(); // mount relative to the drawing: rx, ry, rz in the camera's axes
                                                      // [rad]
};
using LiveCameras = std::map<std::string, LiveCamera>; // "top", "bottom"

/// A robot standing on the floor at given angles. Floor frame: sole of the lower foot, of the left one if both carry
/// (they differ by less than a centimetre); x forward, y left, z up [m].
class RobotOutline {
public:
  /// `angles`: one per joint of the drawing [rad].
  RobotOutline(const Robot& drawing, const Eigen::VectorXd& angles);

  /// Supporting feet: "left", "right", "both".
  const std::string& carries() const { return carries_; }

  /// floorFromOptical (x right, y down, z forward); absent if the robot has no such camera.
  std::optional<RigidTransform> floorFromOptical(const std::string& camera, const LiveCamera& modelState) const;

  /// Outline for display: `hull` [[from, to, radius]] of its parts, `feet` {left, right} their outlines, `centre` of
  /// mass, `gaze` [from, to] from the top camera ahead, `carries` "left" | "right" | "both", `views` by camera: the
  /// visible floor up to 3 m, as a polygon [m].
  nlohmann::json toJson(const LiveCameras& cameras) const;

private:
  const Robot& drawing_;
  Eigen::VectorXd angles_;
  std::vector<RigidTransform> floorFromLink_;
  std::string carries_ = "both";
};

/// Angles by joint name; unnamed joints are 0. Absent if a value is not a number.
std::optional<Eigen::VectorXd> parseNamedAngles(const nlohmann::json& byName, const Robot& drawing);

/// Angles in HULKs' joint order, as robots send them. Absent for a wrong number of values or non-numbers.
std::optional<Eigen::VectorXd> parseOrderedAngles(const nlohmann::json& list, const Robot& drawing);

/// Intersection of a pixel's ray with the floor [m]; absent above the horizon.
std::optional<Eigen::Vector2d> intersectFloor(const RigidTransform& floorFromOptical, const CameraIntrinsics& lens,
                                              const Eigen::Vector2d& pixel);

/// A camera's pose and intrinsics at exposure.
struct CameraView {
  RigidTransform floorFromOptical;
  CameraIntrinsics lens;
};

/// Tracks boards on the floor over live images: the mean of each board's last poses predicts its corners in the next
/// image. Differences between images show unmodelled joint and camera errors.
class FloorBoardTracker {
public:
  explicit FloorBoardTracker(std::vector<Board> boards) : boards_{std::move(boards)} {}

  /// Adds a view of a board and returns the predicted corners [px]. Empty if the pose is undetermined (a corner above
  /// the horizon, fewer than two corners) or the board or a corner is unknown.
  std::vector<Eigen::Vector2d> update(const BoardCorners& seen, const CameraView& eye);

  /// Floor plan of the tracked boards: [{"id", "columns", "rows", "square", "x", "y", "yaw"}] [m, rad].
  nlohmann::json toJson() const;

private:
  struct Place {
    double x = 0, y = 0, yaw = 0; // floorFromBoard [m, rad]
  };
  const Board* board(const std::string& id) const;
  Place mean(const std::string& id) const;
  void addView(const std::string& id, const Place& view); // forgets the earlier views if the board has moved

  std::vector<Board> boards_;
  std::map<std::string, std::deque<Place>> views_; // last views by board
};

} // namespace naocal

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

/// What is believed of a camera beyond the drawing.
struct LiveCamera {
  CameraIntrinsics intrinsics;
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero(); // of its mount: rx, ry, rz in the camera's axes [rad]
};
using LiveCameras = std::map<std::string, LiveCamera>; // "top", "bottom"

/// A robot on the floor at given angles. The floor's frame is the sole of the foot that carries it, the lower one; the
/// left one where both do (they differ by less than a centimetre): x forward, y left, z up [m].
class RobotOutline {
public:
  /// `angles`: one per joint of the drawing [rad].
  RobotOutline(const Robot& drawing, const Eigen::VectorXd& angles);

  /// Which feet carry it: "left", "right", "both".
  const std::string& carries() const { return carries_; }

  /// floorFromOptical (x right, y down, z forward); absent: the robot has no such camera.
  std::optional<RigidTransform> floorFromOptical(const std::string& camera, const LiveCamera& belief) const;

  /// For a drawing: `hull` [[from, to, radius]] of its parts, `feet` {left, right} their outlines, `centre` of mass,
  /// `gaze` [from, to] from the top camera ahead, `carries` "left" | "right" | "both", `views` by camera: what it sees
  /// of the floor up to 3 m, as a polygon [m].
  nlohmann::json toJson(const LiveCameras& cameras) const;

private:
  const Robot& drawing_;
  Eigen::VectorXd angles_;
  std::vector<RigidTransform> floorFromLink_;
  std::string carries_ = "both";
};

/// Angles by the joints' names, those that are not named at rest (0). Absent: some value is no number.
std::optional<Eigen::VectorXd> parseNamedAngles(const nlohmann::json& byName, const Robot& drawing);

/// Angles in HULKs' order of joints, as robots send them. Absent: there are not as many, or they are no numbers.
std::optional<Eigen::VectorXd> parseOrderedAngles(const nlohmann::json& list, const Robot& drawing);

/// Where a ray through a pixel meets the floor; absent where it does not [m].
std::optional<Eigen::Vector2d> intersectFloor(const RigidTransform& floorFromOptical, const CameraIntrinsics& lens,
                                              const Eigen::Vector2d& pixel);

/// A picture's camera when it was taken.
struct CameraView {
  RigidTransform floorFromOptical;
  CameraIntrinsics lens;
};

/// Boards on the floor as pictures show them, one after the other: where each lies in the mean of its last views, and
/// where a picture should hence show its corners. What is off from picture to picture is what the robot does not know
/// about its joints and cameras.
class FloorBoardTracker {
public:
  explicit FloorBoardTracker(std::vector<Board> boards) : boards_{std::move(boards)} {}

  /// Takes a view of a board in; afterwards `predicted` tells where these corners should have been [px]. Empty: the
  /// picture does not tell where it lies (a corner above the horizon), or there is no such board or corner.
  std::vector<Eigen::Vector2d> update(const BoardCorners& seen, const CameraView& eye);

  /// For a plan: [{"id", "columns", "rows", "square", "x", "y", "yaw"}] of those seen so far [m, rad].
  nlohmann::json toJson() const;

private:
  struct Place {
    double x = 0, y = 0, yaw = 0; // floorFromBoard [m, rad]
  };
  const Board* board(const std::string& id) const;
  Place mean(const std::string& id) const;

  std::vector<Board> boards_;
  std::map<std::string, std::deque<Place>> views_; // by board, the last ones
};

} // namespace naocal

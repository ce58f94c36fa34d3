#pragma once

#include "data/Board.hpp"

#include <Eigen/Core>
#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

using Seconds = std::chrono::duration<double>;

/// A pinhole camera with OpenCV's distortion terms k1, k2, p1, p2, k3. Pixel (0,0) is the centre of the top-left pixel.
struct CameraIntrinsics {
  int width = 640, height = 480;         // [px]
  double fx = 0, fy = 0, cx = 0, cy = 0; // [px]
  std::array<double, 5> distortion{};    // [1]
};

enum class SupportFoot { left, right, both, none };

/// One set-up of the robot: all captures of a stance share the placement of the support sole.
struct Stance {
  int id = 0;
  SupportFoot supportFoot = SupportFoot::left;
  std::optional<Placement> placement; // surveyed worldFromSole; absent: to be estimated
};

/// Kind of a repeat: at rest, after a re-approach, or after the robot was put down anew.
enum class RepeatKind { rest, reapproach, restand };

/// Joint data of a capture; each list in the order of `CaptureSet::jointNames`, or empty.
struct JointReadings {
  std::vector<double> measured;    // raw encoder angles [rad]; NaN where not recorded
  std::vector<double> commanded;   // raw, without calibration [rad]
  std::vector<double> velocity;    // [rad/s]
  std::vector<double> approach;    // -1, 0, +1: direction of the last motion
  std::vector<double> temperature; // [degC]
  std::vector<double> current;     // [A]
};

/// Corners of one board in one picture.
struct BoardCorners {
  std::string board;
  std::vector<int> ids;
  std::vector<Eigen::Vector2d> uv; // [px] in the distorted image
};

/// One picture of a still robot by one camera.
struct Capture {
  int id = 0;
  std::string pose;
  int repeat = 0;
  RepeatKind repeatKind = RepeatKind::rest;
  Seconds time{0}; // middle of the exposure
  std::string camera;
  SupportFoot supportFoot = SupportFoot::left;
  int stance = 0;
  JointReadings joints;
  std::optional<Eigen::Vector2d> imu;               // angleX, angleY [rad]
  std::optional<std::array<double, 8>> fsr;         // force sensors: left FL, FR, RL, RR, then right [kg]
  std::string image;                                // relative to the set's folder; empty: not stored
  std::optional<std::vector<BoardCorners>> corners; // absent: not detected yet; empty: nothing found
  std::shared_ptr<const nlohmann::json> source;     // as read; preserves unknown keys
};

/// A folder of captures of one robot: the exchange format (captures.json).
struct CaptureSet {
  std::string name; // name of the folder
  std::string model = "V6", bodyId, headId;
  std::vector<std::string> jointNames;
  std::map<std::string, CameraIntrinsics> cameras;
  std::vector<Board> boards;
  std::vector<Stance> stances;
  std::vector<Capture> captures;
  std::shared_ptr<const nlohmann::json> source; // as read; preserves unknown keys
};

} // namespace naocal

#pragma once

#include "data/Board.hpp"
#include "data/Instruments.hpp"

#include <Eigen/Core>
#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

using Seconds = std::chrono::duration<double>;

/// A pinhole camera with OpenCV's distortion terms k1, k2, p1, p2, k3. Pixel (0,0) is the centre of the top-left pixel.
struct CameraIntrinsics {
  static constexpr int mostPixels = 100'000; // of a side, in any file

  int width = 640, height = 480;         // [px]
  double fx = 0, fy = 0, cx = 0, cy = 0; // [px]
  std::array<double, 5> distortion{};    // [1]
};

/// How a camera is mounted on a robot that a URDF describes, or beside it.
struct CameraMounting {
  std::string link;      // "world": it stands beside the robot
  bool isOptical = true; // axes of the mount's frame: x right, y down, z forward; else x forward, y left, z up
  std::optional<Placement> placement; // linkFromMount; absent on a link: the link's own frame, in the world: unknown
  std::optional<Placement> guess;     // of an unknown one in the world
  std::optional<Placement> sigma;     // 1 sigma of the placement; 0 where not given in the file
};

enum class SupportFoot { left, right, both, none };

/// One set-up of the robot: all captures of a stance share the placement of its support.
struct Stance {
  int id = 0;
  SupportFoot supportFoot = SupportFoot::left; // none: `supportLinks`, or the base
  std::optional<Placement> placement;          // surveyed worldFromSole (of the first one) or worldFromBase; absent: to
                                               // be estimated
  std::vector<std::string> supportLinks;       // links whose soles rest flat on the floor; empty: the base stands
};

/// Kind of a repeat: at rest, after a re-approach, or after the robot was put down anew.
enum class RepeatKind { rest, reapproach, restand };

/// Their words in files, in the order of the enums.
inline const std::vector<std::string_view> supportFootWords{"left", "right", "both", "none"};
inline const std::vector<std::string_view> repeatKindWords{"rest", "reapproach", "restand"};

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

/// One picture of a still robot by one camera, or other readings of it at one instant.
struct Capture {
  int id = 0;
  std::string pose;
  int repeat = 0;
  RepeatKind repeatKind = RepeatKind::rest;
  Seconds time{0};    // middle of the exposure
  std::string camera; // empty: no picture
  SupportFoot supportFoot = SupportFoot::left;
  int stance = 0;
  JointReadings joints;
  std::optional<Eigen::Vector2d> imu;               // angleX, angleY [rad]
  std::optional<std::array<double, 8>> fsr;         // force sensors: left FL, FR, RL, RR, then right [kg]
  std::string image;                                // relative to the set's folder; empty: not stored
  std::optional<std::vector<BoardCorners>> corners; // absent: not detected yet; empty: nothing found
  std::vector<PointReading> points;
  std::vector<FrameReading> frames;
  std::vector<ContactReading> contacts;
  std::shared_ptr<const nlohmann::json> source; // as read; preserves unknown keys
};

/// A folder of captures of one robot: the exchange format (captures.json).
struct CaptureSet {
  std::string name;             // name of the folder
  std::filesystem::path folder; // that it was read from; empty: from none
  int version = 1;              // of the format: 2 for a robot with a URDF, and for readings other than corners
  std::string model = "V6", bodyId, headId;
  std::string urdf, base; // file in the set's folder instead of a model, and the link that stands (empty: its root)
  std::vector<std::string> jointNames;
  std::map<std::string, CameraIntrinsics> cameras;
  std::map<std::string, CameraMounting> mountings; // of cameras that are not mounted as the model says
  std::vector<Board> boards;
  Instruments instruments;
  std::map<std::string, Placement> soles;     // linkFromSole by link; z up, origin on the floor
  std::map<std::string, double> encoderSteps; // by joint [rad]
  std::map<std::string, double> slipSteps;    // one motor turn, seen at the joint [rad]
  Eigen::Vector3d gravity{0, 0, -9.81};       // in the world [m/s^2]
  std::vector<Stance> stances;
  std::vector<Capture> captures;
  std::shared_ptr<const nlohmann::json> source; // as read; preserves unknown keys
};

} // namespace naocal

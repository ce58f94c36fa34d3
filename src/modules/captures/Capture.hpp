#pragma once

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

/// Where a frame lies in its parent: parentFromFrame = T(x, y, z) Rz(yaw) Ry(pitch) Rx(roll).
struct Placement {
  double x = 0, y = 0, z = 0;          // [m]
  double roll = 0, pitch = 0, yaw = 0; // [rad]
};

/// A pinhole camera with OpenCV's distortion terms k1, k2, p1, p2, k3. Pixel (0,0) is the centre of the top-left pixel.
struct CameraIntrinsics {
  int width = 640, height = 480;         // [px]
  double fx = 0, fy = 0, cx = 0, cy = 0; // [px]
  std::array<double, 5> distortion{};    // [1]
};

/// What is printed on a ChArUco board.
struct CharucoPattern {
  std::string dictionary = "DICT_4X4_100";
  int squaresX = 7, squaresY = 5;
  double squareLength = 0.08, markerLength = 0.06; // [m]
  int firstMarkerId = 0;
  bool legacyPattern = false; // the sheet of OpenCV before 4.6: differs for even squaresY
};

/// A target with numbered corners: a ChArUco board, or single marks when `pattern` is absent.
struct Board {
  std::string id;
  std::string link = "floor"; // where it is fixed: the floor or a link of the robot
  std::optional<CharucoPattern> pattern;
  std::vector<Eigen::Vector3d> points; // pointInBoard by corner id [m]; for a pattern its inner corners
  std::optional<Placement> placement;  // linkFromBoard, surveyed; absent: to be estimated
  Placement placementGuess;            // where the estimate starts, with hasGuess
  bool hasGuess = false;
  std::optional<Placement> placementSigma; // how far off the guess may be (1 sigma); 0 where the file does not say
};

/// Inner corner i of a pattern: ((i mod (squaresX-1)) + 1, -((i div (squaresX-1)) + 1), 0) * squareLength.
std::vector<Eigen::Vector3d> innerCorners(const CharucoPattern& pattern);

enum class SupportFoot { left, right, both, none };

/// One way of standing: all captures of a stance share the placement of the support foot's sole.
struct Stance {
  int id = 0;
  SupportFoot supportFoot = SupportFoot::left;
  std::optional<Placement> placement; // worldFromSole, surveyed; absent: to be estimated
};

enum class RepeatKind { rest, reapproach, restand };

/// What the robot reported at a capture, each list in the order of `CaptureSet::jointNames` or empty.
struct JointReadings {
  std::vector<double> measured;    // RAW encoder angles [rad]; NaN where not recorded
  std::vector<double> commanded;   // raw space [rad]
  std::vector<double> velocity;    // [rad/s]
  std::vector<double> approach;    // -1, 0, +1: direction of the last motion
  std::vector<double> temperature; // [degC]
  std::vector<double> current;     // [A]
};

/// The corners of one board in one picture.
struct BoardCorners {
  std::string board;
  std::vector<int> ids;
  std::vector<Eigen::Vector2d> uv; // [px] in the distorted image
};

/// One still instant seen by one camera.
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
  std::optional<std::array<double, 8>> fsr;         // left FL, FR, RL, RR, then right [kg]
  std::string image;                                // relative to the set's folder; empty: none kept
  std::optional<std::vector<BoardCorners>> corners; // absent: not looked for yet; empty: nothing seen
  std::shared_ptr<const nlohmann::json> source;     // as read: keeps keys that are unknown here
};

/// A folder of captures of one robot: the one exchange format (captures.json).
struct CaptureSet {
  std::string name; // the folder's name
  std::string model = "V6", bodyId, headId;
  std::vector<std::string> jointNames;
  std::map<std::string, CameraIntrinsics> cameras;
  std::vector<Board> boards;
  std::vector<Stance> stances;
  std::vector<Capture> captures;
  std::shared_ptr<const nlohmann::json> source; // as read: keeps keys that are unknown here
};

} // namespace naocal

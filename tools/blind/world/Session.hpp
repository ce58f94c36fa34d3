#pragma once

#include "world/Drawing.hpp"
#include "world/Flaws.hpp"

#include <optional>

namespace blind {

/// A robot with all its errors.
struct Robot {
  const Drawing* drawing = nullptr;
  Eigen::VectorXd offsets;                   // reading - true angle, by joint [rad]
  std::array<Eigen::Vector3d, 2> mountTurns; // of top and bottom camera: Rx, Ry, Rz after the nominal mount [rad]
  Flaws flaws;
};

/// The camera in the set's header.
struct LensDistortion {
  static constexpr int width = 640, height = 480;
  static constexpr double focal = 598, cx = 320, cy = 240; // [px]
};

/// The printed boards: A2 sheets with 7 x 5 squares.
struct Sheet {
  static constexpr int squaresX = 7, squaresY = 5, corners = (squaresX - 1) * (squaresY - 1);
  static constexpr double square = 0.08, marker = 0.06; // [m]
};

struct FloorPlace {
  double x = 0, y = 0, yaw = 0; // [m, m, rad]
};

struct Stance {
  int side = 0; // support foot: 0 left, 1 right
  FloorPlace place;
};

enum class RepeatKind { rest, reapproach, restand };

/// One moment of rest: joint readings and an image of both cameras.
struct Reading {
  int pose = 0, repeat = 0, stance = 0, approachNumber = 0; // readings at rest share the approach
  RepeatKind kind = RepeatKind::reapproach;
  double time = 0;             // [s]
  Eigen::VectorXd commanded;   // raw [rad]
  Eigen::VectorXd measured;    // raw [rad]
  Eigen::VectorXd unread;      // motor position minus `measured`: rounding and sensor noise [rad]
  Eigen::VectorXd stuck;       // frictional deflection of the link [rad]
  Eigen::VectorXd excursion;   // start of the last motion relative to the pose [rad]
  Eigen::VectorXd velocity;    // [rad/s]
  Eigen::VectorXd temperature; // [degrees Celsius]
};

/// Corners of one board in one image.
struct BoardSight {
  int reading = 0, camera = 0, board = 0;
  std::vector<int> ids;
  double sigma = 0; // of its corners, per axis [px]
};

/// A permanent displacement at one time.
struct Displacement {
  int which = 0;
  double time = 0;
  FloorPlace by;
};

/// Everything that happened, except the robot's flaws.
struct Session {
  std::vector<FloorPlace> boards;
  std::vector<Stance> stances;
  std::vector<Reading> readings; // in order of time
  std::vector<BoardSight> sights;
  std::optional<Displacement> kickedBoard, slippedStance;
};

} // namespace blind

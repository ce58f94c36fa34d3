#pragma once

#include "writer/Drawing.hpp"
#include "writer/Flaws.hpp"

#include <optional>

namespace blind {

/// A robot with everything that is wrong with it.
struct Robot {
  const Drawing* drawing = nullptr;
  Eigen::VectorXd offsets;                   // read minus true angle, by joint [rad]
  std::array<Eigen::Vector3d, 2> mountTurns; // of top and bottom camera: Rx, Ry, Rz after the nominal mount [rad]
  Flaws flaws;
};

/// The camera as the set's header gives it.
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
  int side = 0; // of the foot that carries: 0 left, 1 right
  FloorPlace place;
};

enum class RepeatKind { rest, reapproach, restand };

/// One moment of rest at which the angles were read and both cameras looked.
struct Reading {
  int pose = 0, repeat = 0, stance = 0, approachNumber = 0; // readings at rest share the approach
  RepeatKind kind = RepeatKind::reapproach;
  double time = 0;             // [s]
  Eigen::VectorXd commanded;   // raw [rad]
  Eigen::VectorXd measured;    // raw [rad]
  Eigen::VectorXd unread;      // where the motor really stood minus `measured`: rounding and the sensor's noise [rad]
  Eigen::VectorXd stuck;       // friction holds the link so far from where it belongs [rad]
  Eigen::VectorXd excursion;   // the last motion came from so far beside [rad]
  Eigen::VectorXd velocity;    // [rad/s]
  Eigen::VectorXd temperature; // [degrees Celsius]
};

/// Corners of one board in one picture.
struct BoardSight {
  int reading = 0, camera = 0, board = 0;
  std::vector<int> ids;
  double sigma = 0; // of its corners, per axis [px]
};

/// Something moved once, at a time, and stayed there.
struct Displacement {
  int which = 0;
  double time = 0;
  FloorPlace by;
};

/// What happened: everything but the robot's flaws.
struct Session {
  std::vector<FloorPlace> boards;
  std::vector<Stance> stances;
  std::vector<Reading> readings; // in the order of time
  std::vector<BoardSight> sights;
  std::optional<Displacement> kickedBoard, slippedStance;
};

} // namespace blind

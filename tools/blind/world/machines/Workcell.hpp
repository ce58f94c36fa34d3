#pragma once

#include "world/Session.hpp"
#include "world/machines/Machine.hpp"

#include <optional>

namespace blind {

/// How a machine is measured.
enum class Witness {
  wristCamera,   // a camera on the hand sees a board in the world
  cameraBeside,  // a camera in the world sees a board on the hand
  trackedPoints, // a tracker measures markers on the hand
  trackedFrame,  // a tracker measures the pose of the hand
  footAndHead,   // a camera on the head sees a board on the floor, on which the machine stands on one foot
  touch          // a ball on the hand touches places with known distances
};

/// A machine with all its errors, and what measures it.
struct Workcell {
  Witness witness = Witness::wristCamera;
  const Machine* machine = nullptr;
  Eigen::VectorXd offsets; // reading - true angle, by joint [rad], [m]
  MachineFlaws flaws;
  Transform handFromTool;   // of the camera (x right, y down, z forward), the board or the tracked frame on the hand
  Transform worldFromStand; // of the board, the camera or the tracker in the world
  Transform worldFromSole;  // of a machine that stands on a foot
  std::vector<Eigen::Vector3d> points;        // of the board; markers or the ball on the hand, in its frame [m]
  std::vector<Eigen::Vector3d> places;        // in the world [m]
  std::vector<std::pair<int, int>> distances; // between these places
  struct Move {
    double time = 0; // [s]
    Transform by;    // standFromMovedStand
  };
  std::optional<Move> moved;
};

/// Whether it is measured by a camera; whether that is carried.
bool seesBoard(Witness witness);
bool carriesCamera(Witness witness);

/// A reading and what was measured at it.
struct WorkcellReading : Reading {
  std::vector<int> seen;                               // points of the board; the place touched
  Eigen::Matrix3d about = Eigen::Matrix3d::Identity(); // near the tracked frame's rotation
};

using WorkcellSession = std::vector<WorkcellReading>; // in order of time

/// Its body, which keeps references to the cell.
MachineBody bodyOf(const Workcell& cell);
MachineBody bodyOf(Workcell&&) = delete;

/// Angles of the links before springs give way.
Eigen::VectorXd linkAngles(const Workcell& cell, const WorkcellReading& reading);

/// Noiseless measurements of one reading: pixels of the points seen; coordinates of markers or of the frame's origin in
/// the tracker's frame [m], and its rotation vector from the reading's `about` [rad]; the ball minus its place [m].
Eigen::VectorXd measure(const Workcell& cell, const MachineBody& body, const WorkcellReading& reading,
                        const Eigen::VectorXd& angles);

/// Pose of the tracked frame in the tracker's frame.
Transform standFromHand(const Workcell& cell, const MachineBody& body, const WorkcellReading& reading,
                        const Eigen::VectorXd& angles);

/// Distances between places [m].
Eigen::VectorXd placeDistances(const Workcell& cell);

/// Small rotation vector from `from` to `to`, in the axes of `from` [rad].
Eigen::Vector3d rotationVector(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to);

} // namespace blind

#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace naocal {

/// Noise of a simulated robot other than a NAO, 1 sigma.
struct SceneNoise {
  double pixel = 0.3;            // of a corner, per axis [px]
  double encoder = 1.2e-4;       // of a reading, before it is rounded to `encoderSteps` [rad]
  double pose = 0;               // deflection behind the encoder, drawn anew in every pose [rad]
  double approach = 0;           // further deflection, drawn anew at every approach to a pose [rad]
  double tracker = 5e-4;         // of a tracker that tells no `sigma`, per axis [m]
  double trackerRotation = 1e-3; // of a tracker that tells no `sigmaRotation`, per axis [rad]
  double contact = 2e-4;         // of a touch where the scene tells no `contactSigma`, per axis [m]
};

/// A robot and what measures it: what a simulation starts from.
struct RobotScene {
  CaptureSet set; // as the simulated set will tell it: robot, cameras, boards, instruments, one stance; no captures
  std::map<std::string, Placement> about;   // roughly where things stand that the set does not place: "boards.plate"
  std::map<std::string, AngleRange> ranges; // of joints, within their limits [rad]
  SceneNoise noise;
};

/// Whether the robot stands on soles in its first stance; otherwise its base stands in the world.
bool standsOnSole(const CaptureSet& set);

/// The tracker with this id; the set must have it.
const Tracker& findTracker(const CaptureSet& set, const std::string& id);

/// The robot of a simulation: a set without anything but its robot, joints and stance. `robot`: path of a URDF, or a
/// shipped model. `foot`: what a model with soles stands on.
CaptureSet makeRobotOnly(const std::string& robot, SupportFoot foot);

/// Reads what measures the robot: a JSON file of the format naocal-scene with the keys of a capture set of version 2.
/// Throws InputError with file, path, expected and found.
///
/// Instead of a `placement` (of boards, cameras beside the robot, trackers and frames) or a `point` (of markers and
/// places) an entry may have `about`: roughly where it truly stands, which the simulated set does not tell. `distances`
/// need no `metres`: they are measured in the simulation. Further keys: `base`, `supportLinks`, `ranges` (of joints),
/// `noise`.
RobotScene readRobotScene(const std::filesystem::path& file, const CaptureSet& robotOnly);

/// `name`: the file's, for error messages.
RobotScene parseRobotScene(const std::string& text, const std::string& name, const CaptureSet& robotOnly);

/// A scene for a robot without a scene file. A model that stands on its feet: four boards on the floor, seen by its
/// cameras. A URDF with a link that looks like a camera's optical frame and moves: a board on the floor, where the
/// camera sees it most often. Any other: a tracker that sees a marker on the last link.
RobotScene makeDefaultScene(const CaptureSet& robotOnly, std::uint64_t seed);

} // namespace naocal

#pragma once

#include "poses/PoseFile.hpp"
#include "scenes/RobotScene.hpp"
#include "simulation/Renderer.hpp"
#include "simulation/Truth.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Settings of a simulation of any robot. Random values are uniform in [-range, range].
struct ScenePlan {
  std::size_t poses = 24;
  std::vector<PlayablePose> given;          // taken instead of random poses: their angles are what the encoders read
  int samples = 3;                          // per pose
  RepeatKind repeatKind = RepeatKind::rest; // what happens between the samples of a pose; not `restand`
  double offsetRange = 0;                   // per motor [rad]
  double mountRange = 0;                    // per camera on a link and axis [rad]
  double mountShiftRange = 0;     // per camera on a link and axis [m]; 0: `placementSigma`, if the scene gives it
  std::vector<std::string> flaws; // hidden: "effect@place", "effect@place.unknown", "reversedJoint@J", "countSlip@J"
  double flawScale = 1;
  bool images = false;     // what the cameras see is kept to be rendered; no corners are given
  bool heavyTails = false; // of corners: Student's t with 4 degrees of freedom instead of a normal distribution
  double grossShare = 0;   // fraction of corners with gross errors [1]
  double grossSize = 8;    // [px]
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> robotSeed, sceneSeed; // of the robot's errors, and of where things stand
  double spread = 1;                                 // how far off `about` things truly stand, as a share of the usual
};

/// A simulated capture set of any robot and its ground truth.
struct SceneSimulation {
  CaptureSet set; // its URDF keeps the place that it was read from
  Truth truth;
  std::vector<RenderedScene> scenes;              // with `images`: per capture, empty without a camera
  std::map<std::string, CameraIntrinsics> lenses; // with `images`: the true ones
  std::size_t links = 0, shapedLinks = 0;         // of the robot, and of those the ones with a shape to collide with
};

/// Simulates a robot in random poses of `ScenePoses` in which its cameras see at least eight corners of a board, or, in
/// a scene without cameras, a tracker sees a marker or frame past the robot's shapes; or in the given poses, whatever
/// is seen there. Where the scene has places, it takes as many touches afterwards, place after place: the joint angles
/// bring the true marker to the true place but for the noise of contacts. At rest a touch is recorded once, since the
/// same touch tells nothing twice.
///
/// Readings are those that the library's own model predicts for the true unknowns, plus noise: a simulation tests how
/// well causes are told apart, not the equations. A flaw's unknowns are as large as their plausible size ('naocal
/// effects'), with random signs where either is possible; a spring gives way by 0.02 rad at most. Reproducible by seed.
///
/// Throws InputError for flaws that this robot in this scene cannot have, and if too few poses are found or
/// the given ones see nothing, for a place that no pose touches, and for `restand`: the robot is in one stance. With
/// `images` also for boards without a ChArUco pattern, and for flaws of a board's shape or of the shutter.
SceneSimulation simulateScene(const RobotScene& scene, const ScenePlan& plan);

} // namespace naocal

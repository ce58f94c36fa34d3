#pragma once

#include "world/RandomStream.hpp"
#include "world/Session.hpp"

#include <numbers>
#include <optional>
#include <string>

namespace blind {

constexpr double encoderStep = 2 * std::numbers::pi / 4096; // [rad]

/// Measurement noise.
struct NoiseRegime {
  std::string name = "clean";
  double pixel = 0.3;         // of a corner, per axis, 1 sigma [px]
  bool heavyTails = false;    // Student's t with 4 degrees of freedom for corners instead of normal; same sigma
  bool quantised = false;     // readings rounded to encoder steps instead of normal noise; same sigma
  double stiction = 0;        // 1 sigma [rad]; half of the variance is common to all approaches of a pose
  double pictureBias = 0;     // shift common to an image's corners, per axis, 1 sigma [px]
  bool foreshortened = false; // more noise on slanted boards
  double jitter = 0;          // of every reading, even while the motor stands still, 1 sigma [rad]
};

/// Plan of a session.
struct SessionPlan {
  int poses = 20, samples = 3, boards = 4;
  int mainSide = 0;                     // support foot: 0 left, 1 right
  bool bothSides = false;               // half of the poses on each foot
  bool rests = false, restands = false; // some repeats without moving, some in a new stance
  bool sortedByKnee = false;            // instead of a random order
  bool sameTemperature = false;         // motors stay at 38 degrees Celsius
  bool warmAnyhow = false;              // recorded temperatures vary independently of the load
  std::optional<RepeatKind> repeats;    // one repeat kind for all samples of a pose
  std::optional<int> sameApproach;      // joint always approached from below
  std::optional<double> hipYawPitch;    // fixed angle [rad]
  double speed = 0.03;                  // residual speed during exposure, rms [rad/s]
  NoiseRegime noise;
};

/// Simulates a session of a robot without flaws, but with its offsets, in front of boards.
Session stageSession(const Robot& robot, const SessionPlan& plan, const std::vector<FloorPlace>& boards,
                     RandomStream& chance);

} // namespace blind

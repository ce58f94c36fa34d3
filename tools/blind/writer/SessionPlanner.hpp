#pragma once

#include "writer/RandomStream.hpp"
#include "writer/Session.hpp"

#include <numbers>
#include <optional>
#include <string>

namespace blind {

constexpr double encoderStep = 2 * std::numbers::pi / 4096; // [rad]

/// What is random in a measurement.
struct NoiseRegime {
  std::string name = "clean";
  double pixel = 0.3;         // of a corner, per axis [px]
  bool heavyTails = false;    // corners by Student's t with 4 degrees of freedom instead of Gauss, of the same sigma
  bool quantised = false;     // readings rounded to the encoder's steps instead of Gauss, of the same sigma
  double stiction = 0;        // [rad]; half of its variance is common to all approaches of a pose
  double pictureBias = 0;     // a shift common to a picture's corners, per axis [px]
  bool foreshortened = false; // corners of slanted boards are worse
  double jitter = 0;          // of every reading, at rest too: the motor stands still [rad]
};

/// How a session is to be held.
struct SessionPlan {
  int poses = 20, samples = 3, boards = 4;
  int mainSide = 0;                     // of the foot that carries; the other one stands idle
  bool bothSides = false;               // half of the poses on either foot
  bool rests = false, restands = false; // some samples are repeated without moving, some after standing up anew
  bool sortedByKnee = false;            // instead of a random order
  bool sameTemperature = false;         // the motors keep 38 degrees
  bool warmAnyhow = false;              // recorded temperatures wander with nothing that matters
  std::optional<RepeatKind> repeats;    // all samples of a pose are repeated this way
  std::optional<int> sameApproach;      // a joint always approached from below
  std::optional<double> hipYawPitch;    // kept at one angle [rad]
  double speed = 0.03;                  // rms of the residual motion when a picture is taken [rad/s]
  NoiseRegime noise;
};

/// Lets a robot without flaws but with its offsets stand in front of boards as planned.
Session stageSession(const Robot& robot, const SessionPlan& plan, const std::vector<FloorPlace>& boards,
                     RandomStream& chance);

} // namespace blind

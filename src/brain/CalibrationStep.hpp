#pragma once

#include "data/Capture.hpp"
#include "hardware/exchange/CompensatedAngles.hpp"

#include <vector>

namespace naocal {

/// A step of a calibration's round.
struct CalibrationStep {
  std::string name;                      // of where it leads, for people
  std::string question;                  // to the person, answered before it begins; empty: none
  bool held = false;                     // a person holds the robot on the way, until the next step begins
  std::vector<CompensatedAngles> points; // to go through and stay at the last one; none: back to the stand
  int pictures = 0;                      // of each camera, taken there
  Capture taken;                         // what all captures of the step have in common: pose, repeat, foot, stance
};

/// The poses of a round of a calibration, one after another.
using CalibrationRound = std::vector<CalibrationStep>;

/// How a round is taken.
struct RoundOptions {
  int pictures = 2;       // of each camera in each pose; on one foot each at an approach of its own
  double approach = 0;    // from how far each joint comes, once from each side [rad]
  std::size_t poses = 0;  // the first so many of them in the round's random order; 0: all
  std::uint64_t seed = 1; // of that order
};

/// The stand with the head turned [deg].
CompensatedAngles lookingFrom(const CompensatedAngles& stand, double yaw, double pitch);

/// The stand with the head at each pair of these angles [deg] times `share`, in random order; pictures are taken at as
/// many approaches as asked, of yaw and pitch from below and from above in turn.
CalibrationRound headRound(const CompensatedAngles& stand, const std::vector<double>& yaws,
                           const std::vector<double>& pitches, double share, const RoundOptions& options);

} // namespace naocal

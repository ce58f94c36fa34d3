#pragma once

#include "calibration/Calibration.hpp"
#include "diagnosis/views/SingleJointCorrection.hpp"
#include "inference/DriverBasis.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// An error that follows something that was recorded: a plot worth looking at.
struct TellingPair {
  enum class Error { right, down, joint }; // of corners [px]; of a joint, as it would explain the misfit [rad]
  enum class Over { driver, column, row }; // a recorded driver; a corner's place in the picture
  Error error = Error::down;
  std::size_t motor = 0; // of Error::joint
  Over over = Over::driver;
  std::size_t driver = 0;     // of Over::driver, into the drivers given
  double from = 0, to = 0;    // the curve where its driver is least and most [px or rad]
  double least = 0, most = 0; // of the curve
  double share = 0;           // of all squared errors of corners that the curve takes away
  double chance = 1;          // that noise alone makes any of the pairs as clear as this one
  bool hasTwoValues = false;  // its driver has no others
};

/// The pairs beyond chance, the most telling first. Of one driver's pairs only the best of joints and the best of
/// corners, of one joint's only the best.
struct TellingPairs {
  std::vector<TellingPair> pairs;
  std::size_t tried = 0;                     // pairs that were looked at
  std::vector<SingleJointCorrection> joints; // errors of joints that were looked at
};

struct TellingOptions {
  Eigen::Index draws = 199; // of turned values: chances are told to 1 / (draws + 1)
  std::uint64_t seed = 1;
  double alarm = 0.05; // the chance that a pair is shown where nothing follows anything
};

/// Every error that can be plotted over everything that may drive it: corners' errors to the right and down, and what
/// each joint would have to be off by, over angles, torques, time, how joints were approached, their temperatures and
/// speeds, and the place in the picture. What follows its driver beyond chance (`Trend`) is ranked by the share of
/// all squared errors that goes with the curve: errors in pixels and of joints are measured by the same yardstick.
TellingPairs findTellingPairs(const FittedModel& fitted, const std::vector<DriverSeries>& drivers,
                              const TellingOptions& options = {});

/// "the torque on LHipPitch", "the direction from which LHipPitch was approached"
std::string describeDriver(const DriverSeries& driver, const Robot& robot);

/// "downward errors over the torque on LHipPitch"
std::string formatTellingLabel(const TellingPair& pair, const std::vector<DriverSeries>& drivers, const Robot& robot);

/// What the plot shows: "Downward errors (±6.0 px) change sign with the direction from which LHipPitch was approached.
/// That is 87 % of the squared error."
std::string formatTellingSentence(const TellingPair& pair, const std::vector<DriverSeries>& drivers,
                                  const Robot& robot);

/// Of the most telling one, or that there is none.
std::string formatTellingSentence(const TellingPairs& telling, const std::vector<DriverSeries>& drivers,
                                  const Robot& robot);

} // namespace naocal

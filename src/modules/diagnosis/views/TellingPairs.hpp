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

/// An error with a significant trend over a recorded quantity: a plot worth showing.
struct TellingPair {
  /// Corner errors [px]; joint deflection that would explain the misfit [rad].
  enum class Error { right, down, joint };
  enum class Over { driver, column, row }; // a recorded driver; position of a corner in the picture
  Error error = Error::down;
  std::size_t motor = 0; // for Error::joint
  Over over = Over::driver;
  std::size_t driver = 0;     // for Over::driver: index of the driver
  double from = 0, to = 0;    // curve at the smallest and largest driver value [px or rad]
  double least = 0, most = 0; // range of the curve
  double share = 0;           // share of the squared corner errors that the curve removes
  double chance = 1;          // family-wise p-value over all pairs
  bool hasTwoValues = false;  // the driver takes only two values
};

/// Significant pairs, most informative first. Keeps one pair of joints and one of corners per driver, and one pair per
/// joint.
struct TellingPairs {
  std::vector<TellingPair> pairs;
  std::size_t tried = 0;                     // number of pairs tested
  std::vector<SingleJointCorrection> joints; // joint errors tested
};

struct TellingOptions {
  Eigen::Index draws = 199; // random sign flips: resolution of the p-values is 1 / (draws + 1)
  std::uint64_t seed = 1;
  double alarm = 0.05; // family-wise false-alarm rate
};

/// Tests every plottable error against everything that may drive it: corner errors to the right and down, and joint
/// errors that would explain the misfit, over angles, torques, time, approach directions, temperatures, speeds, and
/// position in the picture. Ranks significant pairs (`Trend`) by the share of all squared corner errors that the curve
/// removes: a common measure for errors in pixels and of joints.
TellingPairs findTellingPairs(const FittedModel& fitted, const std::vector<DriverSeries>& drivers,
                              const TellingOptions& options = {});

/// For example "the torque on LHipPitch", "the direction from which LHipPitch was approached".
std::string describeDriver(const DriverSeries& driver, const Robot& robot);

/// For example "downward errors over the torque on LHipPitch".
std::string formatTellingLabel(const TellingPair& pair, const std::vector<DriverSeries>& drivers, const Robot& robot);

/// Sentence that describes the plot: "Downward errors (±6.0 px) change sign with the direction from which LHipPitch was
/// approached. That is 87 % of the squared error."
std::string formatTellingSentence(const TellingPair& pair, const std::vector<DriverSeries>& drivers,
                                  const Robot& robot);

/// Sentence about the most informative pair, or that there is none.
std::string formatTellingSentence(const TellingPairs& telling, const std::vector<DriverSeries>& drivers,
                                  const Robot& robot);

} // namespace naocal

#pragma once

#include "calibration/result/CalibrationResult.hpp"
#include "setups/SetUp.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// The unknowns of a fit, by labels, so that it can be repeated on mended captures.
struct AskedModel {
  std::vector<std::string> with, without;
  std::vector<Effect> effects = allEffects();

  /// Those of a model that was built for these measurements.
  static AskedModel of(const Measurements& measurements, const Model& model);

  Model build(const Measurements& measurements) const;
};

/// What a fit leaves of all measurements, those included that a robust fit gives no weight: joint angles as read.
///
/// length = sum over noise levels of min_sigma sum over blocks of -2 ln[(1 - eps) N(r; sigma) + eps / V]
///          + sum (unknown / prior sigma)^2 - 2 ln eps for every reading of a joint beyond its limits
///
/// A block is a view of a board (at most six numbers, as its corners share their error), a point, an orientation or a
/// contact; eps = 1 % is the share of accidents, V the range of what is measured, so that one displaced block costs 30
/// to 60 and no more, and the unit of V, so that another unit of the readings changes nothing. sigma is free: what is
/// left may be another effect. (docs/concepts/diagnosis.md)
struct SetUpFit {
  double length = std::numeric_limits<double>::infinity(); // description length [2 ln]
  double error = std::numeric_limits<double>::infinity();  // rms of all blocks, in usual noises (`usualPx` and so on)
  double typicalError = std::numeric_limits<double>::infinity(); // the same without the worst 5 % of the blocks
  std::string size;        // the rms error for people: "0.4 px"; empty: nothing but contacts
  double numbers = 0;      // that were measured, independent ones
  std::string farPlace;    // where a joint's zero or a camera's mount is off by more than 15 degrees; empty: nowhere
  bool isMountFar = false; // it is a camera's mount
  double farTurn = 0;      // by how much, at most [rad]
  Eigen::VectorXd unknowns;
};

/// Noise per axis of a usual instrument: error beyond ten times as much is that of no calibrated robot.
inline constexpr double usualPx = 0.2, usualMetres = 5e-4, usualRadians = 1e-3;

/// Judges given unknowns; `length` and errors infinite if a prediction is impossible everywhere.
SetUpFit assessFit(const Measurements& measurements, const Model& model, const Eigen::VectorXd& unknowns);

/// How thoroughly captures are fitted anew.
struct FitEffort {
  int iterations =
      30; // a search that starts near its minimum needs 5 to 20; one with a wrong set-up wanders for hundreds
  bool robust = true; // also with a loss that gives up blocks; the better of both counts
};

/// Fits captures from the drawing, joints rigid: first with generous noise, then with as much as the errors show.
/// Absent if no fit is possible.
std::optional<SetUpFit> fitAnew(const Measurements& measurements, const Model& model, const FitEffort& effort);

} // namespace naocal

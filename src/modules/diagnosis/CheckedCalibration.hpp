#pragma once

#include "calibration/Calibration.hpp"
#include "io/InputError.hpp"

#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Captures that cannot be fitted, since their set-up is wrong.
struct WrongSetUpError : InputError {
  WrongSetUpError(std::vector<WrongSetUp> found, std::vector<Finding> told)
      : InputError{told.front().sentence}, setUps{std::move(found)}, findings{std::move(told)} {}

  std::vector<WrongSetUp> setUps;
  std::vector<Finding> findings; // the same
};

/// Calibrates (`calibrate`), and looks for what is wrong with the captures: mistakes of the set-up where the error is
/// that of no robot (`findSetUps`, `findSlippedCounts`), else an accident that explains what the model does not
/// (`findAccidents`). With any, the result is not to be used, and its sentence is that of a diagnosis. Throws
/// WrongSetUpError where no fit is possible and such a mistake explains why, else as `calibrate`.
CalibrationResult calibrateChecked(const Measurements& measurements, const Model& model,
                                   const CalibrationOptions& options = {});

/// "reversedJoint@elbow", one after the other.
std::vector<std::string> labelsOf(const std::vector<WrongSetUp>& found);

} // namespace naocal

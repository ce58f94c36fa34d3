#pragma once

#include "calibration/CandidateTests.hpp"
#include "diagnosis/views/ImageField.hpp"

#include <array>
#include <string>
#include <vector>

namespace naocal {

/// A coefficient of a small expression that follows a curve.
struct Coefficient {
  std::string name;
  double value = 0;
  std::string unit = "rad"; // unit of the value: rad divided by the unit of the expression it multiplies
};

/// A curve of a joint, a camera mount or an image field over a driver that would explain the residuals.
struct DriverCurve {
  std::string place, driver; // as in a user-defined effect: "LKneePitch", "q"; mount: camera and driver, "top", "t";
                             // lens: camera and "u" or "v"; board shape: board and "x" or "y"
  std::string what;          // "the angle of LKneePitch"
  bool isTransient = false;  // over time or temperature
  std::string about;         // mount: axis of rotation, "y"; fields within pictures: direction
  std::string unit = "rad";  // of the curve; "m" for a board's shape, "px" for a lens
  double share = 0;          // explained share of the variance of this joint or mount, or within pictures
  double likelihoodRatio = 0, bayes = 0, amplitude = 0; // amplitude: half of the curve's range [`unit`]
  std::vector<std::array<double, 3>> curve; // (driver, deflection, standard error), in the driver's unit and `unit`
  std::string expression;                   // joints: a small expression that follows the curve
  std::vector<Coefficient> coefficients;    // of `expression`
};

/// A cell of the map: evidence of a curve of this joint or mount over this driver.
struct DriverScore {
  std::string place, driver; // as in a user's effect
  double bayes = 0, pValue = 1;
};

/// Evidence of each joint's deflection and each mount's rotation as curves over all drivers.
struct DriverMap {
  std::vector<DriverScore> cells;
  std::vector<DriverCurve> best; // curves with the most evidence, best first
};
/// Evidence and curves at the fit of the candidate tests.
DriverMap mapDrivers(const CandidateTests& candidateTests, const Measurements& measurements);

/// An image field as a curve, like those of joints. Driver: rows ("y") or columns ("x") for a board, "v" or "u" for a
/// camera. Selects the pair of component and driver with the largest variation.
DriverCurve curveFromField(const ImageField& field, const Measurements& measurements);

} // namespace naocal

#pragma once

#include "diagnosis/evidence/CandidateTests.hpp"
#include "diagnosis/views/ImageField.hpp"

#include <array>
#include <string>
#include <vector>

namespace naocal {

/// Of a small expression that follows a curve.
struct Coefficient {
  std::string name;
  double value = 0;
  std::string unit = "rad"; // of the value: rad over what it multiplies
};

/// A curve of a joint, of a camera's mount or within pictures over a driver that would explain what is left over.
struct DriverCurve {
  std::string place, driver; // as in a user's effect: "LKneePitch", "q"; of a mount the camera: "top", "t"; of a lens
                             // the camera and "u" or "v", of a board's shape the board and "x" or "y"
  std::string what;          // "the angle of LKneePitch"
  std::string about;         // of a mount: the axis that its curve turns about, "y"; within pictures: the direction
  std::string unit = "rad";  // of the curve; "m" of a board's shape, "px" of a lens
  double share = 0;          // of the scatter (variance) of this joint or mount, or within pictures, that it explains
  double likelihoodRatio = 0, bayes = 0, amplitude = 0; // amplitude: half of the curve's range
  std::vector<std::array<double, 3>> curve;             // driver, deflection, its standard error
  std::string expression;                               // of a joint: a small one that follows the curve
  std::vector<Coefficient> coefficients;                // of that expression
};

/// A cell of the map: how well a curve of this joint or mount over this driver would explain what is left over.
struct DriverScore {
  std::string place, driver; // as in a user's effect
  double bayes = 0, pValue = 1;
};

/// Every joint's deflection and every mount's turning as curves over every driver.
struct DriverMap {
  std::vector<DriverScore> cells;
  std::vector<DriverCurve> best; // the curves that explain most, best first
};
DriverMap mapDrivers(const CandidateTests& inquiry, const Measurements& measurements);

/// A field within pictures as a curve, like those of joints.
/// It varies with, for a board its rows ("y") or columns ("x"), for a camera the picture's ("v", "u"). Of all
/// pairs of a component and a driver the one that varies most.
DriverCurve curveFromField(const ImageField& field, const Measurements& measurements);

} // namespace naocal

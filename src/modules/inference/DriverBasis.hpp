#pragma once

#include "estimation/Model.hpp"
#include "estimation/Residuals.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace naocal {

/// How large a curve's coefficients plausibly are [rad]: some tenths of a degree.
constexpr double curvePriorSigma = 0.005;

/// Legendre polynomials P_1 .. P_count at x in [-1, 1].
Eigen::RowVectorXd legendre(double x, Eigen::Index count);

/// A curve over one driver x, of a joint's deflection or a mount's turning: `count` columns.
struct DriverBasis {
  enum class Shape {
    smooth, // Legendre polynomials of degrees 1 to `count` at (x - middle) / half
    wave,   // sin(waves x), cos(waves x): a gear's or an encoder's ripple
    step,   // sign(x - middle): something slipped
    root    // sign(x) sqrt(|x| / half): a spring that stiffens
  };
  Shape shape = Shape::smooth;
  std::size_t motor = 0;  // the joint that deflects
  std::size_t driver = 0; // into the drivers that it was made from
  Eigen::Index first = 0, count = 0;
  double least = 0, most = 0; // of the driver, where it was seen
  double middle = 0, half = 1;
  int waves = 0;           // per turn of the driver
  std::size_t choices = 1; // cells of this shape, of which at most one is true

  /// Its columns at a value of the driver.
  Eigen::RowVectorXd basisAt(double x) const;
};

/// How much a driver must change to have changed, in its unit: less is a sum's rounding.
constexpr double leastChange = 1e-9;

/// A driver's values, each once: those that differ by rounding only are one.
std::set<double> distinctValues(const std::vector<double>& values);
/// Polynomials up to a degree over a driver's distinct values, of which there are two or more; as many as those allow.
DriverBasis polynomialBasis(const std::set<double>& distinct, Eigen::Index degree);
/// Ripples of two and more periods per turn: one per turn is an effect with a name.
std::vector<DriverBasis> rippleBases();
/// Steps at moments between these times.
std::vector<DriverBasis> stepBases(const std::set<double>& times);
/// The root of a driver with these values.
DriverBasis rootBasis(const std::set<double>& distinct);

/// The middles of gaps between neighbouring times, at most `most`: all times in so many parts, the widest gap of each.
/// What happens once happens while nothing is recorded, and the likelier the longer that lasts.
std::vector<double> midpointsBetween(const std::set<double>& times, std::size_t most);

/// Something that was known at every capture and that a joint's deflection may vary with.
struct DriverSeries {
  Driver kind = Driver::time;
  std::size_t joint = 0;                 // whose
  std::string name;                      // as in expressions: "LHipPitch", "tau_LHipPitch", "t", "approach", "T", "qd"
  std::string unit, what;                // "rad", "the angle of LHipPitch"
  std::optional<std::size_t> motor = {}; // the only joint whose curve it can drive
  std::vector<double> atPicture = {};    // its value, per picture

  double mean(const std::vector<std::size_t>& pictures) const;
};

/// The columns of the joint x driver map: every joint's deflection as a curve over every driver.
///
/// Smooth cells have degrees 1 to 4 over the driver's range (the constant is the joint's offset), as many as its
/// distinct values allow. Beside them stand the shapes that no polynomial follows: ripples of the joint's own angle, a
/// step at a moment, the root of its own torque.
struct DriverColumns {
  std::vector<DriverSeries> drivers;
  std::vector<DriverBasis> cells; // of one motor side by side
  Eigen::Index count = 0;         // of all columns

  /// A motor's part of a pose: its deflections, one row each, by its columns.
  struct Block {
    Eigen::Index firstDeflection = 0, firstColumn = 0;
    Eigen::MatrixXd values;
  };
  std::vector<std::vector<Block>> blocks; // per pose
};

/// The map of each joint in `measurements.joints` over each of `drivers`. `poses`: as the residuals make them, for the
/// places of their deflections.
DriverColumns buildDriverColumns(const Measurements& measurements, std::vector<DriverSeries> drivers,
                                 const std::vector<PoseRows>& poses);

/// Only deflections in proportion to each of `drivers`.
DriverColumns buildProportionalColumns(const Measurements& measurements, std::vector<DriverSeries> drivers,
                                       const std::vector<PoseRows>& poses);

/// Everything that joints' deflections may vary with: angles and torques of all joints in use, time; and of each joint
/// itself how it was approached, its temperature and its speed. What was recorded nowhere or never changed is left out.
std::vector<DriverSeries> collectDrivers(const Measurements& measurements, const Model& model,
                                         const Eigen::VectorXd& unknowns);

/// A driver's name in the expression of an effect at `motor`: "q" and "tau" for its own.
std::string expressionName(const DriverSeries& driver, std::size_t motor);

/// A camera's mount turning as time passes or the head moves: a rotation vector in the mount's axes, each component a
/// curve over one driver. The curves' constants are `cameraRotation`.
struct MountCurve {
  Term term;        // coefficients of the first column about x, y, z, then those of the second [rad]
  DriverBasis cell; // columns of each component

  std::size_t camera() const { return term.site; }
};

/// The cameras' part of the map: every mount over time and over the angles of the joints that carry it. Two polynomials
/// suffice: a mount has no gear.
std::vector<MountCurve> buildMountCurves(const Measurements& measurements, const std::vector<DriverSeries>& drivers);

} // namespace naocal

#pragma once

#include "estimation/Model.hpp"
#include "estimation/Residuals.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Prior standard deviation of a curve's coefficients [rad], about 0.3 degrees.
constexpr double curvePriorSigma = 0.005;

/// Legendre polynomials P_1 .. P_count at x in [-1, 1].
Eigen::RowVectorXd legendre(double x, Eigen::Index count);

/// Basis of a curve over one driver x, for a joint's deflection or the rotation of a camera mount: `count` columns.
struct DriverBasis {
  enum class Shape {
    smooth, // Legendre polynomials of degrees 1 to `count` at (x - middle) / half
    wave,   // sin(waves x), cos(waves x): gear or encoder ripple
    step,   // sign(x - middle): a sudden slip
    root    // sign(x) sqrt(|x| / half): a stiffening spring
  };
  Shape shape = Shape::smooth;
  std::size_t motor = 0;             // index of the deflecting joint
  std::size_t driver = 0;            // index into `DriverColumns::drivers`, or the drivers passed in
  Eigen::Index first = 0, count = 0; // first column and number of columns
  double least = 0, most = 0;        // observed range of the driver
  double middle = 0, half = 1;
  int waves = 0;           // periods per turn of the driver
  std::size_t choices = 1; // number of cells of this shape, at most one of which is true

  /// The basis functions at driver value x: 1 x `count`.
  Eigen::RowVectorXd basisAt(double x) const;
};

/// Smallest difference between two driver values, in the driver's unit; smaller ones are rounding errors.
constexpr double leastChange = 1e-9;

/// The distinct values of a driver; values closer than `leastChange` count as one.
std::set<double> distinctValues(const std::vector<double>& values);
/// Polynomials over a driver's distinct values, up to `degree` or as many as the values allow. Requires at least two
/// values.
DriverBasis polynomialBasis(const std::set<double>& distinct, Eigen::Index degree);
/// Ripples of 2 to 8 periods per turn. One period per turn is a named effect.
std::vector<DriverBasis> rippleBases();
/// Steps over time, at the midpoints of `midpointsOf(gapsBetween(times), 24)`.
std::vector<DriverBasis> stepBases(const std::set<double>& times);
/// Square-root basis over a driver with these values.
DriverBasis rootBasis(const std::set<double>& distinct);

/// Two neighbouring times.
using TimeGap = std::pair<double, double>;
/// In order; none of fewer than two times.
std::vector<TimeGap> gapsBetween(const std::set<double>& times);
/// Midpoints of at most `most` gaps, which are in order: they are divided into `most` runs of about equal number, and
/// each run contributes its widest gap. A one-off event falls between captures, most likely into the longest gap.
std::vector<double> midpointsOf(const std::vector<TimeGap>& gaps, std::size_t most);

/// A quantity known at every capture that a joint's deflection may depend on.
struct DriverSeries {
  Driver kind = Driver::time;
  std::size_t joint = 0;                 // joint that the quantity belongs to
  std::string name;                      // as in expressions: "LHipPitch", "tau_LHipPitch", "t", "approach", "T", "qd"
  std::string unit, what;                // unit and description: "rad", "the angle of LHipPitch"
  std::optional<std::size_t> motor = {}; // the only joint whose curve it may drive; empty: any joint
  std::vector<double> atPicture = {};    // value per picture

  /// Mean over these pictures.
  double mean(const std::vector<std::size_t>& pictures) const;
};

/// For example "the torque on LHipPitch", "the temperature of LHipPitch"; of a direction also what its signs mean.
std::string describeDriver(const DriverSeries& driver, const Robot& robot);

/// Columns of the joint x driver map: each joint's deflection as a curve over each driver.
///
/// Smooth cells have degrees 1 to 4 over the driver's range (the constant is the joint's offset), as many as its
/// distinct values allow. Further shapes cover what no polynomial follows: ripples of the joint's own angle, a step
/// over time, the square root of its own torque.
struct DriverColumns {
  std::vector<DriverSeries> drivers;
  std::vector<DriverBasis> cells; // cells of one motor are adjacent
  Eigen::Index count = 0;         // total number of columns

  /// A motor's block of a pose: one row per deflection, one column per column of that motor.
  struct Block {
    Eigen::Index firstDeflection = 0, firstColumn = 0;
    Eigen::MatrixXd values;
  };
  std::vector<std::vector<Block>> blocks; // per pose
};

/// The map of each joint in `measurements.joints` over each of `drivers`. `poses` are the rows of the residuals; they
/// give the indices of the deflections.
DriverColumns buildDriverColumns(const Measurements& measurements, std::vector<DriverSeries> drivers,
                                 const std::vector<PoseRows>& poses);

/// As `buildDriverColumns`, with only a deflection proportional to each driver.
DriverColumns buildProportionalColumns(const Measurements& measurements, std::vector<DriverSeries> drivers,
                                       const std::vector<PoseRows>& poses);

/// All quantities that joint deflections may depend on: angles and torques of all joints in use, and time; per joint
/// also its approach direction, temperature and speed. Omits quantities that are missing from a capture or never
/// change.
std::vector<DriverSeries> collectDrivers(const Measurements& measurements, const Model& model,
                                         const Eigen::VectorXd& unknowns);

/// Name of a driver in the expression of an effect at `motor`: "q" and "tau" for the motor's own angle and torque.
std::string expressionName(const DriverSeries& driver, std::size_t motor);

/// Rotation of a camera mount over time or head angle: a rotation vector in the mount's axes, each component a curve
/// over one driver. The constant part is `cameraRotation`.
struct MountCurve {
  Term term;        // coefficients of the first column about x, y, z, then of the second [rad]
  DriverBasis cell; // basis of each component

  std::size_t camera() const { return term.placeIndex; }
};

/// The cameras' part of the map: every mount over time and over the angles of the joints that carry it. At most two
/// polynomial degrees, since a mount has no gear.
std::vector<MountCurve> buildMountCurves(const Measurements& measurements, const std::vector<DriverSeries>& drivers);

} // namespace naocal

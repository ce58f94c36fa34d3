#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <set>
#include <vector>

namespace naocal {

/// How large a curve's coefficients plausibly are [rad]: some tenths of a degree.
constexpr double plausibleCurve = 0.005;

/// Legendre polynomials P_1 .. P_count at x in [-1, 1].
Eigen::RowVectorXd legendre(double x, Eigen::Index count);

/// A curve over one driver x, of a joint's deflection or a mount's turning: `count` columns.
struct DriverCell {
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
  Eigen::RowVectorXd basis(double x) const;
};

/// How much a driver must change to have changed, in its unit: less is a sum's rounding.
constexpr double leastChange = 1e-9;

/// A driver's values, each once: those that differ by rounding only are one.
std::set<double> distinctValues(const std::vector<double>& values);
/// Polynomials up to a degree over a driver's distinct values, of which there are two or more; as many as those allow.
DriverCell smoothCell(const std::set<double>& distinct, Eigen::Index degree);
/// Ripples of two and more periods per turn: one per turn is an effect with a name.
std::vector<DriverCell> rippleCells();
/// Steps at moments between these times.
std::vector<DriverCell> stepCells(const std::set<double>& times);
/// The root of a driver with these values.
DriverCell rootCell(const std::set<double>& distinct);

/// The middles of gaps between neighbouring times, at most `most`: all times in so many parts, the widest gap of each.
/// What happens once happens while nothing is recorded, and the likelier the longer that lasts.
std::vector<double> momentsBetween(const std::set<double>& times, std::size_t most);

} // namespace naocal

#pragma once

#include "residuals/Residuals.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A joint's deflection as a smooth function of one driver: `count` columns.
struct DriverCell {
  std::size_t motor = 0;
  std::size_t driver = 0; // into `DriverColumns::drivers`
  Eigen::Index first = 0, count = 0;
  double middle = 0, half = 1; // the driver's range: the curve's argument is (driver - middle) / half
};

/// Something that was known at every capture and that a joint's deflection may vary with.
struct DriverValues {
  Driver kind = Driver::time;
  std::size_t joint = 0;                 // whose
  std::string name;                      // as in expressions: "LHipPitch", "tau_LHipPitch", "t", "approach", "T", "qd"
  std::string unit, what;                // "rad", "the angle of LHipPitch"
  std::optional<std::size_t> motor = {}; // the only joint whose curve it can drive
  std::vector<double> atPicture = {};    // its value, per picture
};

/// The columns of the joint x driver map: every joint's deflection as a curve over every driver.
///
/// A cell's columns are Legendre polynomials of degrees 1 to 4 over the driver's range (the constant is the joint's
/// offset), as many as its distinct values allow.
struct DriverColumns {
  std::vector<DriverValues> drivers;
  std::vector<DriverCell> cells; // of one motor side by side
  Eigen::Index count = 0;        // of all columns

  /// A motor's part of a pose: its deflections, one row each, by its columns.
  struct Block {
    Eigen::Index firstDeflection = 0, firstColumn = 0;
    Eigen::MatrixXd values;
  };
  std::vector<std::vector<Block>> blocks; // per pose
};

/// Curves of up to `degree` of each joint in `measurements.joints` over each of `drivers`. `poses`: as the residuals
/// make them, for the places of their deflections.
constexpr Eigen::Index curveDegree = 4;
DriverColumns driverColumns(const Measurements& measurements, std::vector<DriverValues> drivers,
                            const std::vector<PoseSystem>& poses, Eigen::Index degree = curveDegree);

/// Legendre polynomials P_1 .. P_count at x in [-1, 1].
Eigen::RowVectorXd curveBasis(double x, Eigen::Index count);

} // namespace naocal

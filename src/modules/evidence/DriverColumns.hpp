#pragma once

#include "evidence/DriverCell.hpp"
#include "residuals/Residuals.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Something that was known at every capture and that a joint's deflection may vary with.
struct DriverValues {
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

/// The map of each joint in `measurements.joints` over each of `drivers`. `poses`: as the residuals make them, for the
/// places of their deflections.
DriverColumns driverColumns(const Measurements& measurements, std::vector<DriverValues> drivers,
                            const std::vector<PoseRows>& poses);

/// Only deflections in proportion to each of `drivers`.
DriverColumns proportionalColumns(const Measurements& measurements, std::vector<DriverValues> drivers,
                                  const std::vector<PoseRows>& poses);

} // namespace naocal

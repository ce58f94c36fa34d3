#pragma once

#include "evidence/DriverColumns.hpp"
#include "residuals/Model.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Everything that joints' deflections may vary with: angles and torques of all joints in use, time; and of each joint
/// itself how it was approached, its temperature and its speed. What was recorded nowhere or never changed is left out.
std::vector<DriverValues> driversOf(const Measurements& measurements, const Model& model,
                                    const Eigen::VectorXd& unknowns);

/// A driver's name in the expression of an effect at `motor`: "q" and "tau" for its own.
std::string nameAt(const DriverValues& driver, std::size_t motor);

} // namespace naocal

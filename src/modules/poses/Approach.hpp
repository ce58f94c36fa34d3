#pragma once

#include "residuals/Model.hpp"

#include <random>

namespace naocal {

/// Per joint the motion that ends in a pose, at random: -1 from above, +1 from below; as one for joints of one motor.
Eigen::VectorXd randomApproach(const Robot& robot, std::mt19937_64& random);

/// Whether an effect of the model depends on it.
bool looksAtApproach(const Model& model);

} // namespace naocal

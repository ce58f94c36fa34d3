#pragma once

#include "residuals/Model.hpp"

namespace naocal {

/// Unknowns of one model in the order of another, by their names; new ones at zero.
Eigen::VectorXd carried(const Model& from, const Eigen::VectorXd& unknowns, const Model& to);

} // namespace naocal

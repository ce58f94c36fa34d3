#pragma once

#include "residuals/Model.hpp"

#include <Eigen/Core>
#include <optional>

namespace naocal {

/// The model with priors as wide as a fit asks for: an effect that was added to the base gets the wider of the
/// plausible widths (`plausibleWidths`) where that makes what was measured likelier. Else a prior that expects
/// something smaller draws it towards zero, and a twin takes the rest. Absent where no prior need be wider. `unknowns`,
/// `variances`: of the fit, its priors included.
std::optional<Model> withPriorsFor(const Model& model, const Eigen::VectorXd& unknowns,
                                   const Eigen::VectorXd& variances);

} // namespace naocal

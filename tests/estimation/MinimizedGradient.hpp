#pragma once

#include "estimation/Residuals.hpp"

#include <catch2/catch.hpp>

namespace naocal {

/// Checks by differences of 1e-3 `scales` that the gradient is that of the cost minimised over all joint errors.
/// `tolerance`: relative to the norm of the gradient in these scales.
inline void checkMinimizedGradient(const Residuals& residuals, const Eigen::VectorXd& here,
                                   const Eigen::VectorXd& scales, double tolerance) {
  const auto costAt = [&](const Eigen::VectorXd& unknowns, Eigen::VectorXd& gradient) {
    Residuals::State state = residuals.startState(unknowns);
    Residuals::Linear linear;
    REQUIRE(residuals.linearize(state, linear));
    gradient = linear.gradient;
    return linear.cost;
  };
  Eigen::VectorXd gradient, other;
  costAt(here, gradient);
  const Eigen::VectorXd scaled = gradient.cwiseProduct(scales);
  for (Eigen::Index k = 0; k < here.size(); ++k) {
    CAPTURE(k);
    const Eigen::VectorXd step = 1e-3 * scales[k] * Eigen::VectorXd::Unit(here.size(), k);
    CHECK((costAt(here + step, other) - costAt(here - step, other)) / 2e-3 ==
          Approx(scaled[k]).margin(tolerance * scaled.norm()));
  }
}

} // namespace naocal

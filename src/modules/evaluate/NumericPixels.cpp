#include "evaluate/NumericPixels.hpp"

#include "math/LinearAlgebra.hpp"

namespace naocal {

/// Predicted minus measured, all corners.
std::optional<Eigen::VectorXd> NumericPixels::pixels(const Eigen::VectorXd& unknowns) const {
  const std::vector<SightingResidual> sightings = residuals_.sightings(residuals_.start(unknowns));
  Eigen::Index count = 0;
  for (const SightingResidual& sighting : sightings) {
    count += sighting.residual.size();
  }
  Eigen::VectorXd result(count);
  Eigen::Index row = 0;
  for (const SightingResidual& sighting : sightings) {
    for (const double difference : sighting.residual.reshaped()) {
      result[row++] = -difference;
    }
  }
  return result.allFinite() ? std::optional{result} : std::nullopt;
}

bool NumericPixels::linearise(const Residuals::State& state, Linear& result) const {
  constexpr double step = 1e-5; // [rad]
  const auto here = pixels(state.unknowns);
  if (!here) {
    return false;
  }
  Eigen::MatrixXd slopes(here->size(), state.unknowns.size());
  for (Eigen::Index i = 0; i < state.unknowns.size(); ++i) {
    const Eigen::VectorXd little = step * Eigen::VectorXd::Unit(state.unknowns.size(), i);
    const auto above = pixels(state.unknowns + little), below = pixels(state.unknowns - little);
    if (!above || !below) {
      return false;
    }
    slopes.col(i) = (*above - *below) / (2 * step);
  }
  result = {0.5 * here->squaredNorm(), slopes.transpose() * *here, slopes.transpose() * slopes};
  return true;
}

} // namespace naocal

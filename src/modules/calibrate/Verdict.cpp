#include "calibrate/Verdict.hpp"

#include "calibrate/FloorError.hpp"
#include "calibrate/WeakDirections.hpp"
#include "calibrate/Words.hpp"
#include "geometry/Angles.hpp"

#include <fmt/format.h>

namespace naocal {

void judge(const Measurements& measurements, const Model& model, CalibrationResult& result) {
  constexpr double largestFloorError = 0.05;       // [m]
  constexpr double largestScatter = radians(0.03); // [rad]: what a NAO's stiction does at most
  using About = Warning::About;
  const auto warn = [&](About about, std::string sentence) { result.warnings.push_back({about, std::move(sentence)}); };
  result.weak = weakDirections(model, result);
  result.floorErrorAt2m = floorErrorAt2m(measurements, model, result);
  result.usable = result.converged;
  if (!result.converged) {
    warn(About::fit, "the search did not converge: try --restarts 20, and check the robot's model and the boards");
  }
  for (const Term& term : model.terms()) {
    const Estimate& estimate = result.estimates[term.first];
    if (term.effect.name == "jointOffset" && term.asked && estimate.learned < 0.5) {
      result.usable = false;
      warn(About::offset,
           fmt::format("{} cannot be learned from these captures ({:.0f} % learned, ±{:.1f}°): "
                       "add poses that move it, or leave it out "
                       "with --without {}",
                       inWords(term, 0), 100 * std::max(0.0, estimate.learned), degrees(estimate.sigma), term.label()));
    }
  }
  if (result.floorErrorAt2m > largestFloorError) {
    result.usable = false;
    warn(About::floor, fmt::format("a floor point 2 m ahead would be seen {:.0f} mm off (1 sigma); at most {:.0f} mm "
                                   "is good enough to play: take more poses or more boards",
                                   1e3 * result.floorErrorAt2m, 1e3 * largestFloorError));
  }
  if (result.pValue < 0.001) {
    warn(About::fit,
         fmt::format("the model does not explain these captures (chi2/dof {:.2f}, p {}); error bars "
                     "are widened by {:.2f}; 'naocal diagnose' looks for what is missing",
                     result.chi2 / result.dof,
                     result.pValue < 1e-9 ? "below 1e-9" : fmt::format("{:.1g}", result.pValue), result.sigmaScale));
  }
  if (result.noise.pose > largestScatter) {
    warn(About::fit, fmt::format("joints scatter by {:.3f}° from pose to pose beyond their encoders' noise: stiction, "
                                 "or an effect that the model misses; 'naocal diagnose' tells which",
                                 degrees(result.noise.pose)));
  }
  std::size_t corners = 0;
  for (const Doubt& doubt : result.doubts) {
    corners += doubt.corners.size();
  }
  if (corners > 0) {
    warn(About::fit, fmt::format("{} not fit the rest and got little or no weight: listed under doubtful",
                                 corners == 1 ? std::string{"1 corner does"} : fmt::format("{} corners do", corners)));
  }
}

std::vector<std::string> sentences(const std::vector<Warning>& warnings) {
  std::vector<std::string> result;
  for (const Warning& warning : warnings) {
    result.push_back(warning.sentence);
  }
  return result;
}

} // namespace naocal

#include "diagnosis/OwnEffect.hpp"

#include "diagnosis/evidence/CrossValidation.hpp"
#include "effects/UserEffect.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/ModelBuilder.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

nlohmann::json curveAsUserEffect(const DriverCurve& curve) {
  nlohmann::json unknowns = nlohmann::json::object();
  for (const Coefficient& coefficient : curve.coefficients) {
    const double size = std::max(1e-6, 2 * std::abs(coefficient.value));
    unknowns[coefficient.name] = {{"unit", coefficient.unit}, {"sigma", std::stod(fmt::format("{:.2g}", size))}};
  }
  return {{"name", fmt::format("found_{}_over_{}", curve.place, curve.driver)},
          {"at", curve.place},
          {"correction", curve.expression},
          {"unknowns", unknowns}};
}

std::optional<OwnEffect> fitOwnEffect(const DriverCurve& curve, const Measurements& measurements,
                                      const StepwiseSelection& selection, const Diagnosis& diagnosis,
                                      const CandidateTestOptions& options) {
  if (curve.coefficients.empty() || curve.isTransient) {
    return std::nullopt;
  }
  const nlohmann::json definition = curveAsUserEffect(curve);
  const Effect effect = parseUserEffect(JsonCursor{definition, "the curve"}, measurements.robot);
  const std::vector<Term> terms = candidateTerms(measurements, {effect});
  if (terms.empty()) {
    return std::nullopt;
  }
  const CandidateTests asked{{measurements, selection.model(), selection.fit()}, terms, {.draws = 0, .map = false}};
  const std::optional<CrossValidation> held = crossValidate(asked, selection.model(), diagnosis.suggested, {{0}});
  if (!held || held->afterPx.front() >= held->beforePx) {
    return std::nullopt;
  }
  Model larger = withWeighingOffsets(measurements, selection.model(), terms);
  larger.add(terms.front());
  const CalibrationResult fit = selection.fitLarger(larger);
  std::vector<Term> left = selection.testableTerms();
  const CandidateTests after{{measurements, larger, fit}, left, options};
  OwnEffect own{.label = terms.front().label(), .definition = definition.dump()};
  own.step.added = own.label;
  own.step.rmsPx = fit.rmsPx;
  own.step.noiseFloorPx = fit.noiseFloorPx;
  own.step.heldOutPx = held->afterPx.front();
  own.step.chi2 = fit.chi2;
  own.step.dof = fit.dof;
  own.step.alarm = after.evidence().pValue;
  return own;
}

} // namespace naocal

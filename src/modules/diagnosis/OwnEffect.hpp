#pragma once

#include "diagnosis/StepwiseSelection.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace naocal {

/// A joint's curve as a person's own effect, as model files define it (`effects/UserEffect.hpp`); the curve must have
/// an expression. Every sigma is twice what was found, so that captures decide.
nlohmann::json curveAsUserEffect(const DriverCurve& curve);

/// The curve as an effect to add: where an expression follows it, and where that lowers the error on poses that its
/// sizes were not fitted to.
std::optional<OwnEffect> fitOwnEffect(const DriverCurve& curve, const Measurements& measurements,
                                      const StepwiseSelection& ladder, const Diagnosis& diagnosis,
                                      const CandidateTestOptions& options);

} // namespace naocal

#pragma once

#include "diagnosis/StepwiseSelection.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace naocal {

/// A joint's curve as a user-defined effect, as in model files (`effects/UserEffect.hpp`). Requires a curve with an
/// expression. Each prior sigma is twice the estimate, so that the captures decide.
nlohmann::json curveAsUserEffect(const DriverCurve& curve);

/// The curve as an effect to add, if it has an expression that lowers the held-out error.
std::optional<OwnEffect> fitOwnEffect(const DriverCurve& curve, const Measurements& measurements,
                                      const StepwiseSelection& selection, const Diagnosis& diagnosis,
                                      const CandidateTestOptions& options);

} // namespace naocal

#pragma once

#include "estimation/Model.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Reason why these captures cannot drive an effect at a place, such as "no temperatures were recorded"; absent if they
/// can.
std::optional<std::string> untestableReason(const Effect& effect, std::size_t at, const Measurements& measurements);

/// Every effect at every place where it can act in these captures, driven or not. Priors fit the robot: its loads, and
/// the uncertainty of mounts that the set states.
std::vector<Term> candidateTerms(const Measurements& measurements, const std::vector<Effect>& effects = allEffects());

/// Candidate terms that these captures can drive and the model lacks.
std::vector<Term> testableTerms(const Measurements& measurements, const Model& model,
                                const std::vector<Effect>& effects = allEffects());

/// Whether a term's drivers depend on where the masses are: torques, or the centre of mass.
bool looksAtWeight(const Term& term);

} // namespace naocal

#pragma once

#include "residuals/Model.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Where an effect can act in these captures: place's number and name. Motors and joints on a path between a camera and
/// a target, lengths of such a path, cameras that saw something, boards with a printed pattern that were seen, soles
/// stood on. A shared effect of boards also sits `everywhere` ("all") where there are several.
std::vector<std::pair<std::size_t, std::string>> placesOf(const Effect& effect, const Measurements& measurements);

/// Why these captures cannot drive an effect at a place, in words such as "no temperatures were recorded"; absent where
/// they can.
std::optional<std::string> whyUntestable(const Effect& effect, std::size_t at, const Measurements& measurements);

/// Every effect at every place where it can act in these captures, driven or not.
std::vector<Term> candidateTerms(const Measurements& measurements, const std::vector<Effect>& effects = allEffects());

/// Those that these captures can drive and that a model does not have.
std::vector<Term> testableTerms(const Measurements& measurements, const Model& model,
                                const std::vector<Effect>& effects = allEffects());

} // namespace naocal

#pragma once

#include "estimation/Model.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// The base model: `jointOffset` of every joint in use, `cameraRotation` of every camera in use, unknown placements;
/// `with` adds and `without` removes effects at places, "E@P" with '*' for any run of letters. Where an effect looks at
/// torques or the centre of mass, the offsets of the other recorded joints that move mass come along. Throws InputError
/// for names that match nothing, and lists the near ones, and for effects that these captures cannot drive.
Model buildModel(const Measurements& measurements, const std::vector<std::string>& with = {},
                 const std::vector<std::string>& without = {}, const std::vector<Effect>& effects = allEffects());

/// Where an effect can act in these captures: place's number and name. Motors and joints on a path between a camera and
/// a target, lengths of such a path, cameras that saw something, boards with a printed pattern that were seen, soles
/// stood on. A shared effect of boards also sits `allSites` ("all") where there are several.
std::vector<std::pair<std::size_t, std::string>> candidateSites(const Effect& effect, const Measurements& measurements);

/// Why these captures cannot drive an effect at a place, in words such as "no temperatures were recorded"; absent where
/// they can.
std::optional<std::string> untestableReason(const Effect& effect, std::size_t at, const Measurements& measurements);

/// Every effect at every place where it can act in these captures, driven or not.
std::vector<Term> candidateTerms(const Measurements& measurements, const std::vector<Effect>& effects = allEffects());

/// Those that these captures can drive and that a model does not have.
std::vector<Term> testableTerms(const Measurements& measurements, const Model& model,
                                const std::vector<Effect>& effects = allEffects());

/// A model with the offsets that come along with `further` terms where those look at torques or the centre of mass.
Model withWeighingOffsets(const Measurements& measurements, Model model, const std::vector<Term>& further);

} // namespace naocal

#pragma once

#include "estimation/Model.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Builds the base model (`jointOffset` of every joint in use, `cameraRotation` of every camera in use, unknown
/// placements), plus effects `with` and minus effects `without`, given as "E@P" with '*' for any run of characters. If
/// an effect uses torques or the centre of mass, adds the offsets of the other recorded joints that move mass. Throws
/// InputError for names that match nothing, listing similar ones, and for effects that these captures cannot drive.
Model buildModel(const Measurements& measurements, const std::vector<std::string>& with = {},
                 const std::vector<std::string>& without = {}, const std::vector<Effect>& effects = allEffects());

/// The model with the offsets required by `further` terms that use torques or the centre of mass.
Model withWeighingOffsets(const Measurements& measurements, Model model, const std::vector<Term>& further);

} // namespace naocal

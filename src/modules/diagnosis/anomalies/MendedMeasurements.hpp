#pragma once

#include "effects/Catalogue.hpp"
#include "measurements/Measurements.hpp"

#include <memory>
#include <string>
#include <vector>

namespace naocal {

/// Measurements as a model's labels take them: the wrong set-ups among the labels are mended, the rest are effects.
struct MendedMeasurements {
  std::shared_ptr<const Measurements> measurements;
  std::vector<std::string> effects, setUps; // labels
};

/// Mends the wrong set-ups among `with` (`mendSetUps`). Without any, the measurements are `given` itself. Throws
/// InputError for set-ups that these captures cannot have.
MendedMeasurements mendMeasurements(const std::shared_ptr<const Measurements>& given,
                                    const std::vector<std::string>& with);

/// Labels of a model's terms (`termLabels`), and of the set-ups that it mends.
std::vector<std::string> termLabels(const MendedMeasurements& mended, const std::vector<std::string>& without,
                                    const std::vector<Effect>& effects);

} // namespace naocal

#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Adds the residuals of a diagnosis's models ("asGiven", and "withSuggested" if something was added), in display
/// units: per joint the deflections that would explain them, residuals within images, boards' shapes and readings that
/// are no corners; the partial residuals of the causes; and the recorded drivers. Data missing in the file stay empty.
/// `data` must contain the images.
void addResidualViewsData(const JsonCursor& diagnosis, nlohmann::json& data);

} // namespace naocal

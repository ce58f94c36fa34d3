#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Adds what the figures of a diagnosis show beside its candidates, in units that people read: which captures belong to
/// each pose, the cameras, how much alike the first candidates are. What the file does not have stays empty or null.
void addFigures(const JsonPlace& diagnosis, nlohmann::json& data);

/// Adds to a candidate its added-variable plot, a point (pose or null, signature, residual) for each pose, and what it
/// would look like. What the file does not have is null. `figures`: as `addFigures` made it.
void addFigures(const JsonPlace& entry, const nlohmann::json& figures, nlohmann::json& candidate);

} // namespace naocal

#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// What the page about an evaluation (EVALUATION.json) shows. Throws InputError with the place of whatever is missing.
nlohmann::json evaluationData(const JsonCursor& evaluation);

} // namespace naocal

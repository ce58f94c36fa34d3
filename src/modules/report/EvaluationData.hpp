#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Data of an evaluation page (EVALUATION.json). Throws InputError with the place of missing or invalid data.
nlohmann::json evaluationData(const JsonCursor& evaluation);

} // namespace naocal

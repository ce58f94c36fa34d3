#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Data of a diagnosis page, in display units. Throws InputError for an invalid file.
nlohmann::json diagnosisData(const JsonCursor& diagnosis);

} // namespace naocal

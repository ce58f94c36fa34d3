#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// What the page about a diagnosis file shows, in units that people read.
nlohmann::json diagnosisData(const JsonCursor& diagnosis);

} // namespace naocal

#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// The findings of a result or a diagnosis that its sentence does not already tell, as {"level", "sentence"}. Files of
/// earlier versions have warnings and suspicions instead.
nlohmann::json findingsData(const JsonCursor& document);

/// Labels that leave out the captures which findings advise to leave out: "leftOut@capture:17".
nlohmann::json leaveOutData(const JsonCursor& document);

} // namespace naocal

#pragma once

#include "calibration/ReadingErrors.hpp"
#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// All candidates of a diagnosis, in display units: state, sizes, evidence, and the plots of the first few. `figures`:
/// poses and pictures, by which plots name captures; `errors`: unit of held-out errors.
nlohmann::json candidatesData(const JsonCursor& diagnosis, const nlohmann::json& figures, const ErrorUnit& errors);

} // namespace naocal

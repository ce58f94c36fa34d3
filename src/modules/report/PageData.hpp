#pragma once

#include "io/JsonReader.hpp"
#include "report/Sources.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// What the page's figures show, in the units that they show it in (degrees, millimetres, pixels).
nlohmann::json pageData(const JsonPlace& result, const Sources& sources);

} // namespace naocal

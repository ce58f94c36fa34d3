#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// How much alike the first candidates are, which of them the captures cannot tell apart, and that in words; null where
/// the diagnosis does not say.
nlohmann::json aliasesData(const JsonPlace& diagnosis);

} // namespace naocal

#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Similarity of the first candidates, the pairs that the captures cannot distinguish, and a sentence; null if the
/// diagnosis has none.
nlohmann::json aliasesData(const JsonCursor& diagnosis);

} // namespace naocal

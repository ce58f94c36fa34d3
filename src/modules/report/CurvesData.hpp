#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Curves of joints' deflections, of mounts, boards and lenses over a driver, in display units; a joint's with a model
/// file that adds it as a custom effect to the `suggested` ones, whose residual it is.
nlohmann::json curvesData(const JsonCursor& diagnosis, const nlohmann::json& suggested);

/// The cells of the joint x driver map; empty if the diagnosis has none.
nlohmann::json mapData(const JsonCursor& diagnosis);

} // namespace naocal

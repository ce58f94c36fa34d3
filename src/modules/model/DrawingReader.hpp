#pragma once

#include "captures/JsonPlace.hpp"
#include "model/Robot.hpp"

namespace naocal {

/// The robot of a complete drawing document (a base, if any, already merged in). Throws InputError at the first place
/// that is not as home/configuration/drawings/NaoV5.json shows it.
Robot readDrawing(const JsonPlace& drawing);

} // namespace naocal

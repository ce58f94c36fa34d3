#pragma once

#include <filesystem>

namespace naocal {

/// Default folder of saved settings of this user's robots: $XDG_STATE_HOME/naocal, otherwise ~/.local/state/naocal (XDG
/// Base Directory Specification: relative paths are ignored). Throws InputError if neither variable is set.
std::filesystem::path stateFolder();

} // namespace naocal

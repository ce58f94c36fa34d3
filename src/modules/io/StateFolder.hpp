#pragma once

#include <filesystem>

namespace naocal {

/// Default folder of what this user's robots learn, and of their runs: $XDG_STATE_HOME/naocal, otherwise
/// ~/.local/state/naocal (XDG Base Directory Specification: relative paths are ignored). Throws InputError if neither
/// variable is set.
std::filesystem::path stateFolder();

} // namespace naocal

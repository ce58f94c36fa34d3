#pragma once

#include <filesystem>

namespace naocal {

/// Where this user's robots keep what they learn, unless told otherwise: $XDG_STATE_HOME/naocal, ~/.local/state/naocal
/// without it (XDG Base Directory Specification: a relative path there is ignored). Throws InputError where neither is
/// known.
std::filesystem::path stateFolder();

} // namespace naocal

#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace naocal {

/// A program by its name: beside this one, in the folders of an installation (bin, libexec/naocal) or of a build, or
/// else on the PATH. Absent if no such file can be run.
std::optional<std::filesystem::path> findProgram(const std::string& name);

/// The same for one of naocal's programs. Throws InputError if it is missing.
std::filesystem::path requireProgram(const std::string& name);

} // namespace naocal

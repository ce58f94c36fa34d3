#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace naocal {

/// Where `naocal` is: beside this program, as it is built or installed, or where the shell would find it.
std::optional<std::filesystem::path> naocalProgram();

/// Starts a program in a process group of its own, without a shell and with nothing that is open here; what it prints
/// goes into the file `output`. Throws InputError when it cannot be started.
pid_t started(const std::filesystem::path& program, const std::vector<std::string>& words, int output);

} // namespace naocal

#pragma once

#include <optional>

namespace CLI {
class App;
}

namespace naocal {

/// Gives an application the help of this folder; before its commands are added, which inherit it.
void useHelp(CLI::App& app);

/// Parses a command line and runs the callback of its command. Returns the exit code where help, the version or (for
/// the hidden --describe) the description in JSON was printed instead. Throws InputError for wrong usage: one
/// sentence with near names and the help to ask for.
std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv);

} // namespace naocal

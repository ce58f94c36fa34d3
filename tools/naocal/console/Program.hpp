#pragma once

#include <string_view>

namespace CLI {
class App;
}

namespace naocal {

/// Completes the commands that a program has with options and callbacks; these set the exit code.
using CompleteCommands = void (*)(CLI::App& app, int& exitCode);

/// The main function of naocal and of the programs that it becomes: runs one of the program's own commands, or becomes
/// the program that has the command. Returns the exit code.
int runProgram(std::string_view program, CompleteCommands complete, int argc, char** argv);

} // namespace naocal

#pragma once

#include <span>
#include <string_view>

namespace CLI {
class App;
}

namespace naocal {

/// A command of naocal: its group in help, what it does, and the program that has it (docs/architecture.md).
struct CommandEntry {
  std::string_view name, group, description, program;
};

/// Programs of the commands: `naocal` itself, and those that it becomes for commands that need large libraries.
inline constexpr std::string_view mainProgram = "naocal", picturesProgram = "naocal-pictures",
                                  evaluateProgram = "naocal-evaluate";

/// All commands, in the order of help.
std::span<const CommandEntry> commandTable();

/// The command's entry; nullptr if the word is no command.
const CommandEntry* findCommand(std::string_view name);

/// Adds all commands to an application, in order and without options. A command's own file completes it.
void addTable(CLI::App& app);

} // namespace naocal

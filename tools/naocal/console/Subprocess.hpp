#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Result of a finished program.
struct ProcessResult {
  int exitCode = -1;
  bool stopped = false; // terminated by SIGINT, SIGTERM or SIGKILL; a crash gives exitCode -1 and a sentence in `said`
  std::string printed;  // standard output
  std::string said;     // standard error
};

/// Runs a program and waits for its end; the first word is its path. Throws InputError if it cannot be started.
ProcessResult runProcess(const std::vector<std::string>& command);

/// The same while its standard error is read: calls `said` with every line of it, and `waiting` ten times a second.
/// Standard output is this program's.
ProcessResult followProcess(const std::vector<std::string>& command, const std::function<void(std::string_view)>& said,
                            const std::function<void()>& waiting);

/// Replaces this process by a program with the same arguments; `arguments` ends with nullptr, as main's do. Throws
/// InputError if it cannot be started.
[[noreturn]] void becomeProgram(const std::filesystem::path& program, char** arguments);

} // namespace naocal

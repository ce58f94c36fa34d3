#pragma once

#include <string>
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

} // namespace naocal

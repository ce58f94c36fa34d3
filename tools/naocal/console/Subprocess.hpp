#pragma once

#include <string>
#include <vector>

namespace naocal {

/// A program that has ended.
struct ProcessResult {
  int exitCode = -1;
  bool stopped = false; // from outside, such as by Ctrl-C; a crash is an exit code of -1 and a sentence in `said`
  std::string printed;  // on standard output
  std::string said;     // on standard error
};

/// Runs a program to its end; the first word is its path. Throws InputError when it cannot be started.
ProcessResult runProcess(const std::vector<std::string>& command);

} // namespace naocal

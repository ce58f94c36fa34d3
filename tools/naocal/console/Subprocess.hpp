#pragma once

#include <string>
#include <vector>

namespace naocal {

/// A program that has ended.
struct Finished {
  int exitCode = -1;
  bool stopped = false; // from outside, such as by Ctrl-C; a crash is an exit code of -1 and a sentence in `said`
  std::string printed;  // on standard output
  std::string said;     // on standard error
};

/// Runs a program to its end; the first word is its path. Throws InputError when it cannot be started.
Finished run(const std::vector<std::string>& command);

} // namespace naocal

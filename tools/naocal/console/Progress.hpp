#pragma once

#include <cstddef>
#include <string>

namespace naocal {

/// Progress of long work on a terminal's standard error (never into a pipe), and a clean stop on Ctrl-C: while one
/// lives, Ctrl-C only makes it answer false.
class Progress {
public:
  explicit Progress(std::string what); // "pictures"
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `all` are done; false: a person wants to stop.
  bool operator()(std::size_t done, std::size_t all) const;
  static bool wasInterrupted();

private:
  std::string what_;
  bool onTerminal_;
};

} // namespace naocal

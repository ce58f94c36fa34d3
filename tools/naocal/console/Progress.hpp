#pragma once

#include <cstddef>
#include <string>

namespace naocal {

/// Progress output on standard error (terminals only), and a clean stop: while an instance exists, Ctrl-C only makes it
/// return false.
class Progress {
public:
  explicit Progress(std::string what); // "pictures"
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Prints `done` of `all`; false after Ctrl-C.
  bool operator()(std::size_t done, std::size_t all) const;
  static bool wasInterrupted();

private:
  std::string what_;
  bool onTerminal_;
};

} // namespace naocal

#pragma once

#include <catch2/catch.hpp>
#include <string>

namespace naocal {

/// Exit code of a test program without failures in which a test lacked a requirement; CTest reports it as skipped.
inline constexpr int skippedExitCode = 77;

/// Whether a test of this program lacked a requirement.
inline bool& isSkipped() {
  static bool skipped = false;
  return skipped;
}

/// Prints why a test, or a part of it, cannot run, and marks the program as skipped.
inline void skip(const std::string& why) {
  isSkipped() = true;
  WARN("skipped: " + why);
}

} // namespace naocal

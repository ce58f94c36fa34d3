#pragma once

#include <catch2/catch.hpp>
#include <string>

namespace naocal {

/// Exit code of a test program that missed what a test needs and found no failure; CTest shows the test as skipped.
inline constexpr int skippedExitCode = 77;

/// Whether a test of this program missed what it needs.
inline bool& isSkipped() {
  static bool skipped = false;
  return skipped;
}

/// Says why a test, or a part of it, cannot run here.
inline void skip(const std::string& why) {
  isSkipped() = true;
  WARN("skipped: " + why);
}

} // namespace naocal

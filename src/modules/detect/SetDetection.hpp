#pragma once

#include "captures/Capture.hpp"
#include "detect/Detection.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace naocal {

/// What a person should know about one capture's picture.
struct CaptureFinding {
  int capture = 0; // Capture::id
  Finding finding;
};

/// What came of looking through a set's pictures. All lists are in the order of the captures.
struct SetDetection {
  std::size_t pictures = 0; // that were looked at
  std::vector<CaptureFinding> findings;
  std::vector<std::string> unreadable; // one sentence per picture that is missing, broken or of the wrong size
};

/// Told after each picture how many of how many are done; false stops the search.
using DetectionProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Finds the corners anew in every capture of `set` that names an image in `folder`, on `threads` threads; the result
/// does not depend on their number. Corners of boards without a pattern are kept, and so are all corners of captures
/// whose picture is unreadable or was not reached.
SetDetection detectInSet(CaptureSet& set, const std::filesystem::path& folder, unsigned threads,
                         const DetectionProgress& progress);

} // namespace naocal

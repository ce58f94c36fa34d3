#pragma once

#include "data/Capture.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// How captures that cannot be used are treated: refused by name, or left out and listed (a set that lacks them must
/// not be written over the one it was read from).
enum class BadCapturePolicy { refuse, skip };

/// A capture set as read, with what was left out.
struct LoadedCaptureSet {
  CaptureSet set;
  std::vector<std::string> skipped; // one sentence per capture that was left out (BadCapturePolicy::skip)
};

/// Reads `<folder>/captures.json`. Throws InputError: file, JSON path, what was expected, what was found.
LoadedCaptureSet readCaptureSet(const std::filesystem::path& folder, BadCapturePolicy bad = BadCapturePolicy::refuse);

/// The same from text; `name` stands for the file in messages and names the set.
LoadedCaptureSet parseCaptureSet(const std::string& text, const std::string& name,
                                 BadCapturePolicy bad = BadCapturePolicy::refuse);

/// The set as JSON text; keys that were read but are unknown here are kept.
std::string formatCaptureSet(const CaptureSet& set);

/// Writes `<folder>/captures.json` whole or not at all; makes the folder.
void writeCaptureSet(const CaptureSet& set, const std::filesystem::path& folder);

/// Words of the file, in the order of the enums.
inline const std::vector<std::string_view> supportFootWords{"left", "right", "both", "none"};
inline const std::vector<std::string_view> repeatKindWords{"rest", "reapproach", "restand"};

} // namespace naocal

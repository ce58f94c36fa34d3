#pragma once

#include "data/Capture.hpp"
#include "io/JsonReader.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

inline constexpr std::size_t mostCaptures = 20'000; // of one set

/// Treatment of unusable captures: refuse the set, or skip and list them (a set with skipped captures must not
/// overwrite its source).
enum class BadCapturePolicy { refuse, skip };

/// A capture set as read, with the skipped captures.
struct LoadedCaptureSet {
  CaptureSet set;
  std::vector<std::string> skipped; // one sentence per skipped capture (BadCapturePolicy::skip)
};

/// Reads `<folder>/captures.json`. Throws InputError with file, JSON path, expected and found.
LoadedCaptureSet readCaptureSet(const std::filesystem::path& folder, BadCapturePolicy bad = BadCapturePolicy::refuse);

/// Parses the set from text; `name` stands for the file in messages and names the set.
LoadedCaptureSet parseCaptureSet(const std::string& text, const std::string& name,
                                 BadCapturePolicy bad = BadCapturePolicy::refuse);

/// A capture set that was read to its end in spite of refusals.
struct SurveyedCaptureSet {
  CaptureSet set;                    // without the captures, boards, cameras and stances that were refused
  std::vector<std::string> refusals; // one sentence per refused place, in reading order; the first is parseCaptureSet's
  AskedKeys asked;                   // keys that the format knows, by object of `set.source`
};

/// Reads the set as parseCaptureSet does, and lists every refusal instead of throwing the first. Throws InputError if
/// the text is no JSON, or another format.
SurveyedCaptureSet surveyCaptureSet(const std::string& text, const std::string& name);

/// Formats the set as JSON; preserves unknown keys that were read.
std::string formatCaptureSet(const CaptureSet& set);

/// Writes `<folder>/captures.json` atomically; creates the folder.
void writeCaptureSet(const CaptureSet& set, const std::filesystem::path& folder);

/// The file of a capture's picture. Throws InputError if its path leads out of the set's folder, also by links.
std::filesystem::path pictureFile(const Capture& capture, const std::filesystem::path& folder);

} // namespace naocal

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A capture set as a document names it.
struct NamedSet {
  std::string place;  // its folder: absolute, or relative to the document's folder
  std::string sha256; // of its captures.json; empty: not known
};

/// Where sets are looked for besides the places that the document names.
struct SetSearch {
  std::filesystem::path document;                 // searched around: its folder, and that folder's neighbours
  std::vector<std::filesystem::path> lookIn = {}; // folders that the user names
};

/// What was found of a set.
struct SoughtSet {
  std::optional<std::filesystem::path> folder;  // with the very captures.json that the document names
  std::optional<std::filesystem::path> changed; // otherwise: a set at its place, but not as the document names it
  std::string sentence; // where it is if not at its place, or why it was not found and what to do; otherwise empty
};

/// Finds a set by its place and, where it is not there as it was, by the SHA-256 of its captures.json: in the folder of
/// the document and those around it, and in `lookIn`. Follows no links to folders and looks at a bounded number of
/// folders. Without a sum, any set at the place, or of that name beside the document, counts. Throws nothing.
SoughtSet findSet(const NamedSet& set, const SetSearch& search);

/// The folder as a document in `folder` should name it: relative if it lies in or near that folder, so that both can be
/// moved together; otherwise absolute. "." is the document's own folder.
std::string placeFrom(const std::filesystem::path& set, const std::filesystem::path& folder);

} // namespace naocal

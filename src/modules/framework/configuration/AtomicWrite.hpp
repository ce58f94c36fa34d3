#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Writes one file atomically (such as `writeAtomically`); throws an exception that gives the reason.
using FileWriter = std::function<void(const std::filesystem::path& file, std::string_view content)>;

/// A file and its new content.
struct FileContent {
  std::filesystem::path file;
  std::string content;
};

/// Writes several files of a folder as one transaction (write-ahead journal): after any crash either all files or none
/// are new. `journal` lists them first, by paths relative to `folder`; `recoverWrites` completes an interrupted write.
void writeFilesAtomically(const std::filesystem::path& journal, const std::filesystem::path& folder,
                          const std::vector<FileContent>& files, const FileWriter& writer);

/// Completes the writes of an interrupted `writeFilesAtomically` and removes the journal; does nothing without a
/// journal. A journal that is broken, or names a file outside the folder (by its path or through links), is ignored as
/// a whole and kept; the returned sentence says why, otherwise it is empty. Absolute paths into the folder, as earlier
/// versions wrote them, are accepted.
std::string recoverWrites(const std::filesystem::path& journal, const std::filesystem::path& folder,
                          const FileWriter& writer);

} // namespace naocal

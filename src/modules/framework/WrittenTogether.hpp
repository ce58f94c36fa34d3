#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Writes a file whole or not at all (`writeAtomically` does); throws what says why not.
using FileWriter = std::function<void(const std::filesystem::path& file, std::string_view content)>;

/// A file and what shall be in it.
struct FileContent {
  std::filesystem::path file;
  std::string content;
};

/// Writes several files, so that after whatever ends the program either all of them or none of them are new: they are
/// noted in `journal` first, from which `finishWriting` goes on.
void writeTogether(const std::filesystem::path& journal, const std::vector<FileContent>& files,
                   const FileWriter& writer);

/// Writes what a program that ended in between did not get to, and removes the journal; does nothing without one.
/// Throws ConfigurationError for a file that is no journal.
void finishWriting(const std::filesystem::path& journal, const FileWriter& writer);

} // namespace naocal

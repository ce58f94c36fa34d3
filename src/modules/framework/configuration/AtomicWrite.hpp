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

/// Writes several files of a folder, so that after whatever ends the program either all of them or none of them are
/// new: they are noted in `journal` first, by their paths in the folder, from which `recoverWrites` goes on.
void writeFilesAtomically(const std::filesystem::path& journal, const std::filesystem::path& folder,
                          const std::vector<FileContent>& files, const FileWriter& writer);

/// Writes what a program that ended in between did not get to, and removes the journal; does nothing without one. A
/// journal that is broken, or names any file outside the folder (by its path or by links), is not obeyed at all and
/// stays: the sentence that is returned says why, else it is empty. Absolute paths into the folder, as earlier versions
/// wrote, are obeyed.
std::string recoverWrites(const std::filesystem::path& journal, const std::filesystem::path& folder,
                          const FileWriter& writer);

} // namespace naocal

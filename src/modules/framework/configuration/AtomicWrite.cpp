#include "framework/configuration/AtomicWrite.hpp"

#include "framework/configuration/ConfigurationLayers.hpp"
#include "io/Folders.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// Whether `file` lies in `folder` after resolving links; false for folders.
bool liesIn(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code failed; // such as circular links
  const auto whole = std::filesystem::canonical(folder, failed);
  const auto inside = failed ? whole : std::filesystem::weakly_canonical(file, failed);
  return !failed && !std::filesystem::is_directory(inside, failed) &&
         std::mismatch(whole.begin(), whole.end(), inside.begin(), inside.end()).first == whole.end();
}

/// The files of a journal. Throws ConfigurationError for a broken journal or a path outside the folder.
std::vector<FileContent> filesOf(const nlohmann::json& noted, const std::filesystem::path& folder) {
  std::vector<FileContent> files;
  try {
    for (const nlohmann::json& one : noted.at("files")) {
      const std::string& name = one.at("file").get_ref<const std::string&>();
      if (!liesIn(folder, folder / name)) {
        throw ConfigurationError{
            fmt::format("expected files in {}, found {}", folder.string(), name.empty() ? "\"\"" : name)};
      }
      files.push_back({folder / name, one.at("content").get<std::string>()});
    }
  } catch (const nlohmann::json::exception&) {
    throw ConfigurationError{"expected files and their content, found something else"};
  }
  return files;
}

/// Removes a journal for good: it must not come back after a power failure and undo what is written later.
void removeJournal(const std::filesystem::path& journal) {
  std::filesystem::remove(journal);
  syncFolder(journal.parent_path());
}

void writeAll(const std::vector<FileContent>& files, const FileWriter& writer) {
  for (const FileContent& one : files) {
    createFolders(one.file.parent_path());
    writer(one.file, one.content);
  }
}

} // namespace

void writeFilesAtomically(const std::filesystem::path& journal, const std::filesystem::path& folder,
                          const std::vector<FileContent>& files, const FileWriter& writer) {
  if (files.empty()) {
    return;
  }
  nlohmann::json noted = {{"files", nlohmann::json::array()}};
  for (const FileContent& one : files) {
    noted["files"].push_back({{"file", one.file.lexically_relative(folder).string()}, {"content", one.content}});
    createFolders(one.file.parent_path());
  }
  createFolders(journal.parent_path());
  writer(journal, noted.dump());
  writeAll(files, writer);
  removeJournal(journal);
}

std::string recoverWrites(const std::filesystem::path& journal, const std::filesystem::path& folder,
                          const FileWriter& writer) {
  std::vector<FileContent> files;
  try {
    const auto noted = readConfiguration(journal);
    if (!noted) {
      return "";
    }
    files = filesOf(*noted, folder);
  } catch (const ConfigurationError& error) {
    return fmt::format("A save that was cut off was noted in {}, but not by this robot, and nothing of it was written: "
                       "{}. Remove that file.",
                       journal.string(), error.what());
  }
  writeAll(files, writer);
  removeJournal(journal);
  return "";
}

} // namespace naocal

#include "io/Folders.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace naocal {

void createFolders(const std::filesystem::path& folder) {
  const auto whole = folder.has_filename() ? folder : folder.parent_path(); // "a/" is "a"
  if (whole.empty() || std::filesystem::is_directory(whole)) {
    return;
  }
  createFolders(whole.parent_path());
  std::filesystem::create_directory(whole);
  syncFolder(whole.parent_path());
}

void syncFolder(const std::filesystem::path& folder) {
  if (const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); file >= 0) {
    ::fsync(file);
    ::close(file);
  }
}

} // namespace naocal

#pragma once

#include <filesystem>
#include <stdlib.h>
#include <string>

namespace naocal {

/// RAII temporary directory, empty at first.
class TemporaryFolder {
public:
  TemporaryFolder() : path_{std::filesystem::temp_directory_path() / "naocal-test-XXXXXX"} {
    std::string pattern = path_.string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace naocal

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace naocal {

/// Reads a whole file. Throws InputError with the file and the reason.
std::string readFile(const std::filesystem::path& file);

/// Writes a file atomically: temporary file in the same folder, fsync, rename. Throws InputError with the reason.
void writeAtomically(const std::filesystem::path& file, std::string_view content);

/// Lower-case hexadecimal SHA-256.
std::string sha256(std::string_view content);

/// RAII temporary directory, mode 0700. Throws InputError if it cannot be created.
class TemporaryDirectory {
public:
  explicit TemporaryDirectory(const std::filesystem::path& parent = std::filesystem::temp_directory_path());
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace naocal

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace naocal {

inline constexpr std::uintmax_t largestFile = std::uintmax_t{1} << 30; // [bytes]

/// Reads a whole regular file. Throws InputError with the file and the reason: also for folders, pipes and devices
/// (never waits for a writer), for more than `most` bytes, for read errors, and if memory is exhausted.
std::string readFile(const std::filesystem::path& file, std::uintmax_t most = largestFile);

/// The file at a relative path within a folder; absent if the path is empty, absolute or invalid, or leads out of the
/// folder by ".." or symbolic links. The file need not exist.
std::optional<std::filesystem::path> fileInside(const std::filesystem::path& folder,
                                                const std::filesystem::path& inside);

/// Writes a file atomically: temporary file in the same folder, fsync, rename. Writes into an existing device or a pipe
/// that is read. Throws InputError with the reason.
void writeAtomically(const std::filesystem::path& file, std::string_view content);

/// Removes temporary files of `writeAtomically` whose writers were killed, in a folder and those below it; leaves those
/// that are being written. Does nothing if there is no such folder.
void removeAbandonedWrites(const std::filesystem::path& folder);
/// The same for one file's, in its folder.
void removeAbandonedWritesOf(const std::filesystem::path& file);

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

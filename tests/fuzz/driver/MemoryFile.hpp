#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace naocal {

/// RAII regular file without a disk, for readers that take a path.
class MemoryFile {
public:
  explicit MemoryFile(std::string_view content) : descriptor_{::memfd_create("input", MFD_CLOEXEC)} {
    if (descriptor_ < 0 || ::write(descriptor_, content.data(), content.size()) != ssize_t(content.size())) {
      throw std::runtime_error{"the system gives no file in memory"};
    }
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
  int descriptor_;
};

} // namespace naocal

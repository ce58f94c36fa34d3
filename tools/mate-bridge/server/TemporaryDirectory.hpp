#pragma once

#include "io/InputError.hpp"

#include <filesystem>
#include <stdlib.h>
#include <string>

namespace naocal {

/// A folder of its own, for nobody else's eyes, that goes away with it.
class TemporaryDirectory {
public:
  explicit TemporaryDirectory(const std::filesystem::path& parent = std::filesystem::temp_directory_path()) {
    std::string name = (parent / "naocal-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw InputError{"no temporary folder could be made; is the disk full?"};
    }
    path_ = name;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace naocal

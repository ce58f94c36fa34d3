#pragma once

#include "io/InputError.hpp"

#include <filesystem>
#include <stdlib.h>
#include <string>

namespace naocal {

/// A folder of its own, for nobody else's eyes, that goes away with it.
class PassingFolder {
public:
  explicit PassingFolder(const std::filesystem::path& parent = std::filesystem::temp_directory_path()) {
    std::string name = (parent / "naocal-panel-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw InputError{"no temporary folder could be made; is the disk full?"};
    }
    path_ = name;
  }
  ~PassingFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace naocal

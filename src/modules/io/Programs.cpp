#include "io/Programs.hpp"

#include "io/InputError.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <sstream>
#include <unistd.h>
#include <vector>

namespace naocal {

namespace {

std::filesystem::path folderOfThisProgram() {
  std::error_code failed; // without /proc
  return std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
}

} // namespace

std::optional<std::filesystem::path> findProgram(const std::string& name) {
  const std::filesystem::path here = folderOfThisProgram();
  const std::filesystem::path above = here.parent_path(); // of bin: the prefix, with libexec/naocal
  std::vector<std::filesystem::path> folders{here, above / "libexec/naocal", above.parent_path() / "bin", above / name};
  const char* path = std::getenv("PATH");
  std::istringstream list{path == nullptr ? "" : path};
  for (std::string folder; std::getline(list, folder, ':');) {
    folders.emplace_back(folder);
  }
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path program = folder / name;
    std::error_code failed;
    if (std::filesystem::is_regular_file(program, failed) && ::access(program.c_str(), X_OK) == 0) {
      return std::filesystem::absolute(program);
    }
  }
  return std::nullopt;
}

std::filesystem::path requireProgram(const std::string& name) {
  const std::optional<std::filesystem::path> found = findProgram(name);
  if (!found) {
    throw InputError{fmt::format("{}: expected the program {} beside this one or on the PATH, found none; install it "
                                 "too, or build the target {}",
                                 folderOfThisProgram().string(), name, name)};
  }
  return *found;
}

} // namespace naocal

#include "Programs.hpp"

#include "io/InputError.hpp"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sstream>
#include <unistd.h>

extern char** environ;

namespace naocal {

pid_t started(const std::filesystem::path& program, const std::vector<std::string>& words, int output) {
  std::vector<char*> arguments{const_cast<char*>(program.c_str())}; // posix_spawn's type; it changes nothing
  for (const std::string& word : words) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1); // sockets stay with the bridge
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all; // it can be ended, whoever started the bridge and how
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t process = 0;
  const int error = posix_spawn(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) {
    throw InputError{fmt::format("{}: cannot be started: {}", program.string(), std::strerror(error))};
  }
  return process;
}

std::optional<std::filesystem::path> naocalProgram() {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  std::vector<std::filesystem::path> folders{here, here.parent_path() / "naocal"};
  const char* path = std::getenv("PATH");
  std::istringstream list{path == nullptr ? "" : path};
  for (std::string folder; std::getline(list, folder, ':');) {
    folders.emplace_back(folder);
  }
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path program = folder / "naocal";
    if (std::filesystem::is_regular_file(program, error) && access(program.c_str(), X_OK) == 0) {
      return std::filesystem::absolute(program);
    }
  }
  return std::nullopt;
}

} // namespace naocal

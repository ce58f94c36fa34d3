#include "console/Subprocess.hpp"

#include "io/InputError.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace naocal {

namespace {

/// Captures a program's output in an unnamed temporary file; unlike a pipe it cannot fill up.
class Output {
public:
  Output() : file_{std::tmpfile()} {
    if (file_ == nullptr) {
      throw InputError{fmt::format("no temporary file can be made: {}", std::strerror(errno))};
    }
  }
  ~Output() { std::fclose(file_); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  int descriptor() const { return fileno(file_); }
  std::string text() const {
    std::string result;
    std::array<char, 4096> part{};
    std::rewind(file_);
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file_)) {
      result.append(part.data(), count);
    }
    return result;
  }

private:
  std::FILE* file_;
};

} // namespace

ProcessResult runProcess(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) {
    words.push_back(const_cast<char*>(word.c_str())); // posix_spawn's type; it does not modify the strings
  }
  words.push_back(nullptr);
  const Output printed, said;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, printed.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, said.descriptor(), STDERR_FILENO);
  pid_t process = 0;
  const int error = posix_spawn(&process, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw InputError{fmt::format("{}: cannot be started: {}", command.front(), std::strerror(error))};
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  ProcessResult result;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.stopped = signal == SIGINT || signal == SIGTERM || signal == SIGKILL;
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.printed = printed.text();
  result.said = said.text();
  if (signal != 0 && !result.stopped) {
    result.said += fmt::format("{} crashed: {}\n", command.front(), strsignal(signal));
  }
  return result;
}

} // namespace naocal

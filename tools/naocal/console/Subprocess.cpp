#include "console/Subprocess.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
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

/// posix_spawn's type of a command; valid as long as the command.
std::vector<char*> wordsOf(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) {
    words.push_back(const_cast<char*>(word.c_str())); // posix_spawn does not modify the strings
  }
  words.push_back(nullptr);
  return words;
}

/// Starts a program. Throws InputError if it cannot be started.
pid_t start(const std::vector<std::string>& command, const posix_spawn_file_actions_t& actions) {
  const std::vector<char*> words = wordsOf(command);
  pid_t process = 0;
  const int error = posix_spawn(&process, words.front(), &actions, nullptr, words.data(), environ);
  if (error != 0) {
    throw InputError{fmt::format("{}: cannot be started: {}", command.front(), std::strerror(error))};
  }
  return process;
}

/// Waits for the end of a program, of which the result has its exit code or the signal.
ProcessResult waitForEnd(pid_t process, const std::string& program) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  ProcessResult result;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.stopped = signal == SIGINT || signal == SIGTERM || signal == SIGKILL;
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (signal != 0 && !result.stopped) {
    result.said = fmt::format("{} crashed: {}\n", program, strsignal(signal));
  }
  return result;
}

/// Redirections of a started program.
class Redirections {
public:
  Redirections() { posix_spawn_file_actions_init(&actions_); }
  ~Redirections() { posix_spawn_file_actions_destroy(&actions_); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;

  void add(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  const posix_spawn_file_actions_t& actions() const { return actions_; }

private:
  posix_spawn_file_actions_t actions_{};
};

/// Hands over the whole lines at the front of a text, and leaves the rest.
void takeLines(std::string& text, const std::function<void(std::string_view)>& said) {
  for (auto end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
    said(std::string_view{text}.substr(0, end));
    text.erase(0, end + 1);
  }
}

} // namespace

ProcessResult runProcess(const std::vector<std::string>& command) {
  const Output printed, said;
  Redirections redirections;
  redirections.add(printed.descriptor(), STDOUT_FILENO);
  redirections.add(said.descriptor(), STDERR_FILENO);
  ProcessResult result = waitForEnd(start(command, redirections.actions()), command.front());
  result.printed = printed.text();
  result.said = said.text() + result.said;
  return result;
}

ProcessResult followProcess(const std::vector<std::string>& command, const std::function<void(std::string_view)>& said,
                            const std::function<void()>& waiting) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw InputError{fmt::format("no pipe can be made: {}", std::strerror(errno))};
  }
  Redirections redirections;
  redirections.add(ends[1], STDERR_FILENO);
  pid_t process = 0;
  try {
    process = start(command, redirections.actions());
  } catch (...) {
    close(ends[0]);
    close(ends[1]);
    throw;
  }
  close(ends[1]);
  constexpr int tenth = 100; // [ms]
  std::string all, open;
  for (bool isOpen = true; isOpen;) {
    pollfd readable{ends[0], POLLIN, 0};
    if (poll(&readable, 1, tenth) > 0) {
      std::array<char, 4096> part{};
      const ssize_t count = read(ends[0], part.data(), part.size());
      isOpen = count > 0 || (count < 0 && errno == EINTR);
      open.append(part.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
      all.append(part.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
      takeLines(open, said);
    }
    waiting();
  }
  close(ends[0]);
  ProcessResult result = waitForEnd(process, command.front());
  result.said = all + result.said;
  return result;
}

void becomeProgram(const std::filesystem::path& program, char** arguments) {
  execv(program.c_str(), arguments);
  throw InputError{fmt::format("{}: cannot be started: {}", program.string(), std::strerror(errno))};
}

} // namespace naocal

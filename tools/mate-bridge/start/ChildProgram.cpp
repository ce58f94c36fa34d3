#include "start/ChildProgram.hpp"

#include "io/InputError.hpp"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace naocal {

namespace {

/// Starts a program in its own process group, without a shell and without inherited descriptors; its output goes to
/// `output`. Throws InputError if it cannot be started.
pid_t startProcess(const std::filesystem::path& program, const std::vector<std::string>& words, int output) {
  std::vector<char*> arguments{const_cast<char*>(program.c_str())}; // posix_spawn's type; it does not modify the
                                                                    // strings
  for (const std::string& word : words) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1); // the child must not inherit sockets
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all; // default signal handling, whatever the bridge inherited
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

} // namespace

/// The state of a child; keeps itself alive until the output is read.
struct ChildProgram::Running : std::enable_shared_from_this<Running> {
  Running(boost::asio::io_context& given, std::string called, std::optional<std::filesystem::path> path,
          std::function<void()> call)
      : name{std::move(called)}, program{std::move(path)}, changed{std::move(call)}, output{given}, soon{given} {}

  void start(const std::vector<std::string>& asked) {
    if (!program) {
      throw InputError{fmt::format(
          "the program {} was not found beside mate-bridge, nor where the shell looks: install it too", name)};
    }
    if (process != 0) {
      throw InputError{"a command is running: wait for it, or end it"};
    }
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw InputError{fmt::format("no pipe can be made: {}", std::strerror(errno))};
    }
    try {
      process = startProcess(*program, asked, ends[1]);
    } catch (...) {
      close(ends[0]);
      close(ends[1]);
      throw;
    }
    close(ends[1]);
    output.assign(ends[0]);
    words = asked;
    lines.assign(1, "");
    exitCode.reset();
    tellNow();
    read();
  }

  void end(int signal) const {
    if (process != 0) {
      kill(-process, signal);
    }
  }

  void read() {
    output.async_read_some(boost::asio::buffer(part),
                           [self = shared_from_this()](boost::system::error_code error, std::size_t count) {
                             self->add({self->part.data(), count});
                             error ? self->ended() : self->read();
                           });
  }

  /// A carriage return restarts the line, as in progress output.
  void add(std::string_view text) {
    for (const char letter : text) {
      if (letter == '\n') {
        lines.emplace_back();
        returned = false;
      } else if (letter == '\r') {
        returned = true;
      } else {
        if (std::exchange(returned, false)) {
          lines.back().clear();
        }
        if (lines.back().size() < longestLine) {
          lines.back() += letter;
        }
      }
      if (lines.size() > mostLines) {
        lines.pop_front();
      }
    }
    if (!std::exchange(told, true)) { // limits messages to five per second
      soon.expires_after(std::chrono::milliseconds{200});
      soon.async_wait([self = shared_from_this()](boost::system::error_code) { self->tellNow(); });
    }
  }

  void ended() {
    output.close();
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    process = 0;
    tellNow();
  }

  void tellNow() {
    told = false;
    if (changed) {
      changed();
    }
  }

  std::string name;
  std::optional<std::filesystem::path> program;
  std::function<void()> changed;
  boost::asio::posix::stream_descriptor output;
  boost::asio::steady_timer soon;
  std::array<char, 4096> part{};
  pid_t process = 0;
  std::vector<std::string> words;
  std::deque<std::string> lines;
  bool returned = false, told = false;
  std::optional<int> exitCode;
};

ChildProgram::ChildProgram(boost::asio::io_context& context, std::string name,
                           std::optional<std::filesystem::path> program, std::function<void()> changed)
    : running_{std::make_shared<Running>(context, std::move(name), std::move(program), std::move(changed))} {}

ChildProgram::~ChildProgram() {
  running_->changed = nullptr;
  running_->end(SIGTERM);
}

void ChildProgram::start(const std::vector<std::string>& words) {
  running_->start(words);
}

void ChildProgram::end(int signal) {
  running_->end(signal);
}

const std::optional<std::filesystem::path>& ChildProgram::program() const {
  return running_->program;
}

const std::vector<std::string>& ChildProgram::words() const {
  return running_->words;
}

const std::deque<std::string>& ChildProgram::lines() const {
  return running_->lines;
}

bool ChildProgram::isRunning() const {
  return running_->process != 0;
}

const std::optional<int>& ChildProgram::exitCode() const {
  return running_->exitCode;
}

std::string ChildProgram::failure() const {
  if (isRunning() || exitCode().value_or(0) == 0) {
    return "";
  }
  for (auto line = running_->lines.rbegin(); line != running_->lines.rend(); ++line) {
    if (!line->empty()) {
      return *line;
    }
  }
  return fmt::format("{} ended with exit code {}", running_->name, *exitCode());
}

} // namespace naocal

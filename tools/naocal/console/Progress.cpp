#include "console/Progress.hpp"

#include <csignal>
#include <fmt/core.h>
#include <unistd.h>

namespace naocal {

namespace {
volatile std::sig_atomic_t stopped = 0;
}

Progress::Progress(std::string what) : what_{std::move(what)}, onTerminal_{isatty(STDERR_FILENO) != 0} {
  std::signal(SIGINT, [](int) { stopped = 1; });
}

Progress::~Progress() {
  std::signal(SIGINT, SIG_DFL);
}

bool Progress::operator()(std::size_t done, std::size_t all) const {
  if (onTerminal_) {
    fmt::print(stderr, "\r{} of {} {}{}", done, all, what_, done == all ? "\n" : "");
  }
  return stopped == 0;
}

bool Progress::wasInterrupted() {
  return stopped != 0;
}

} // namespace naocal

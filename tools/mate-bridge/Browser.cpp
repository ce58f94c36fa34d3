#include "Browser.hpp"

#include "io/Files.hpp"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace naocal {

namespace {

/// Whether a program of this name is on the PATH.
bool isInstalled(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders{path == nullptr ? "" : path};
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((std::filesystem::path{folder} / program).c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

/// A folder that a program may read: the home of an Ubuntu snap, which has no access to other temporary files,
/// otherwise the folder of temporary files.
std::filesystem::path readableFor(std::string program) {
  const char* const home = std::getenv("HOME");
  program = program == "chromium-browser" ? "chromium" : program;
  const std::filesystem::path snap = std::filesystem::path{home == nullptr ? "" : home} / "snap" / program / "common";
  std::error_code ignored;
  return std::filesystem::is_directory(snap, ignored) ? snap : std::filesystem::temp_directory_path();
}

/// Starts a detached program (double fork: no zombie to wait for).
void start(const std::string& program, const std::string& argument) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::fork() == 0) {
      ::setsid();
      ::close_range(STDERR_FILENO + 1, ~0U, 0); // the child must not inherit sockets
      ::execlp(program.c_str(), program.c_str(), argument.c_str(), static_cast<char*>(nullptr));
    }
    ::_exit(0);
  }
  if (child > 0) {
    ::waitpid(child, nullptr, 0);
  }
}

} // namespace

std::unique_ptr<TemporaryDirectory> openInBrowser(const std::string& address) {
  for (const char* const program : {"chromium", "google-chrome", "chromium-browser", "brave-browser", "microsoft-edge",
                                    "xdg-open", "firefox", "open"}) {
    if (isInstalled(program)) {
      auto folder = std::make_unique<TemporaryDirectory>(readableFor(program));
      const std::filesystem::path page = folder->path() / "panel.html";
      writeAtomically(page, fmt::format("<!doctype html><meta http-equiv=\"refresh\" content=\"0;url={}\">", address));
      const bool hasWindows =
          std::string_view{program}.find("open") == std::string_view::npos && program != std::string_view{"firefox"};
      start(program, fmt::format("{}file://{}", hasWindows ? "--app=" : "", page.string()));
      return folder;
    }
  }
  return nullptr;
}

} // namespace naocal

#include "Browser.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace naocal {

namespace {

/// Whether a program of this name lies on the PATH.
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

/// Starts a program that lives on without this one (forked twice, so that nobody must wait for it).
void start(const std::string& program, const std::string& argument) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::fork() == 0) {
      ::setsid();
      ::execlp(program.c_str(), program.c_str(), argument.c_str(), static_cast<char*>(nullptr));
    }
    ::_exit(0);
  }
  if (child > 0) {
    ::waitpid(child, nullptr, 0);
  }
}

} // namespace

bool openInBrowser(const std::string& address) {
  for (const char* const program :
       {"chromium", "google-chrome", "chromium-browser", "brave-browser", "microsoft-edge"}) {
    if (isInstalled(program)) {
      start(program, "--app=" + address);
      return true;
    }
  }
  for (const char* const program : {"xdg-open", "firefox", "open"}) {
    if (isInstalled(program)) {
      start(program, address);
      return true;
    }
  }
  return false;
}

} // namespace naocal

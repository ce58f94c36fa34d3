#pragma once

#include "Skipped.hpp"
#include "TemporaryFolder.hpp"
#include "io/Files.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>

namespace naocal {

inline std::string outputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe{::popen(command.c_str(), "r"), ::pclose};
  std::string output;
  std::array<char, 65536> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) {
    output.append(buffer.data(), count);
  }
  return output;
}

/// The DOM after Chromium has loaded a page in a window 400 px wide, and the console output. Absent without Chromium;
/// the test is then skipped.
inline std::optional<std::string> drawnByBrowser(const std::string& page) {
  if (std::system("command -v chromium > /dev/null") != 0) {
    skip("no chromium");
    return std::nullopt;
  }
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "report.html", page);
  return outputOf(fmt::format(
      "chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync --user-data-dir={0}/profile "
      "--enable-logging=stderr --virtual-time-budget=2000 --window-size=400,900 --dump-dom file://{0}/report.html 2>&1",
      folder.path().string()));
}

} // namespace naocal

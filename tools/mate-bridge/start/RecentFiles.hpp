#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Something that was opened: the paths that were given together, and the time [s since 1970].
struct RecentFile {
  std::vector<std::string> paths;
  std::int64_t opened = 0;
};

/// What was opened in the panel, newest first, and the addresses of robots to look for. Kept in a JSON file of the
/// format "naocal-panel" that all bridges of a user share: every change reads the file first. Entries that cannot be
/// understood are dropped; so are those whose files have gone.
class RecentFiles {
public:
  static constexpr std::size_t mostFiles = 12, mostRobots = 16, mostPaths = 8, longestPath = 4096;

  /// `file`: where the list is kept; empty: nowhere.
  explicit RecentFiles(std::filesystem::path file);

  /// Adds what was opened, or moves it to the front.
  void add(const std::vector<std::string>& paths);
  void forget(const std::vector<std::string>& paths);
  /// Addresses of robots, at most `mostRobots`; their syntax is not checked here.
  void setRobots(const std::vector<std::string>& addresses);

  /// Entries whose paths all exist.
  std::vector<RecentFile> files() const;
  const std::vector<std::string>& robots() const { return robots_; }
  /// Why the list is not kept, one sentence; empty if it is.
  const std::string& problem() const { return problem_; }

private:
  void read();
  void write();

  std::filesystem::path file_;
  std::vector<RecentFile> files_;
  std::vector<std::string> robots_;
  std::string problem_;
};

/// "recording", "capture set", "capture sets" of a folder; "result", "diagnosis", "session" or "model" of a file by the
/// format that its first megabyte names; otherwise "file".
std::string kindOfDataset(const std::string& path);

/// Default file: $XDG_STATE_HOME/naocal/panel.json, otherwise ~/.local/state/naocal/panel.json (XDG Base Directory
/// Specification: relative paths are ignored); empty if neither variable is set.
std::filesystem::path recentFilesFile();

} // namespace naocal

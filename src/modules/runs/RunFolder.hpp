#pragma once

#include "runs/Run.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace naocal {

/// The runs of a folder, and a sentence for each file that is no run.
struct RecordedRuns {
  std::vector<Run> runs; // by time
  std::vector<std::string> broken;
};

/// A folder with one file per run, ID.json. Files are only ever added, so nothing that another program records at the
/// same time is lost.
class RunFolder {
public:
  static constexpr std::size_t mostRuns = 20'000;

  explicit RunFolder(std::filesystem::path folder) : folder_{std::move(folder)} {}
  const std::filesystem::path& path() const { return folder_; }

  /// The newest runs; none if there is no such folder. Leaves out broken files and says what is wrong with each.
  RecordedRuns read(std::size_t most = mostRuns) const;

  /// The newest wanted runs by time, at most `most`. Reads no older files once it has them, so a long history costs no
  /// more than a short one. Leaves out broken files.
  std::vector<Run> readNewest(std::size_t most, const std::function<bool(const Run&)>& isWanted) const;

  /// Writes a run atomically under a new id (`makeRunId`) and returns it. Throws InputError if it cannot be written.
  Run add(Run run) const;

  /// Writes a run under its own id unless that is there already; whether it was written. For runs that another computer
  /// has recorded. Throws InputError for an id that could be no file's name, and if it cannot be written.
  bool addCopy(const Run& run) const;

private:
  std::filesystem::path fileOf(const std::string& id) const { return folder_ / (id + ".json"); }

  std::filesystem::path folder_;
};

/// The folder of runs within a state folder.
std::filesystem::path runsIn(const std::filesystem::path& state);

} // namespace naocal

#include "runs/RunFolder.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "runs/RunFile.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largestRun = 1 << 20; // [bytes]

/// Files of runs by name, that is by time; without temporary files of writers.
std::vector<fs::path> listFiles(const fs::path& folder, std::size_t most, std::vector<std::string>& broken) {
  std::vector<fs::path> files;
  std::error_code problem;
  if (!fs::exists(folder, problem)) {
    return files;
  }
  for (fs::directory_iterator entry{folder, problem}, end; !problem && entry != end; entry.increment(problem)) {
    if (entry->path().extension() == ".json" && entry->path().filename().string().front() != '.') {
      files.push_back(entry->path());
    }
  }
  if (problem) {
    broken.push_back(fmt::format("{}: expected a folder of runs that can be read, found a problem: {}", folder.string(),
                                 problem.message()));
  }
  std::sort(files.begin(), files.end());
  if (files.size() > most) {
    broken.push_back(fmt::format("{}: expected at most {} runs, found {}; the oldest are left out", folder.string(),
                                 most, files.size()));
    files.erase(files.begin(), files.end() - static_cast<std::ptrdiff_t>(most));
  }
  return files;
}

void createFolder(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) {
    throw InputError{fmt::format("{}: cannot be created: {}; choose another place with --state", folder.string(),
                                 problem.message())};
  }
}

} // namespace

RecordedRuns RunFolder::read(std::size_t most) const {
  RecordedRuns recorded;
  for (const fs::path& file : listFiles(folder_, most, recorded.broken)) {
    try {
      const std::string id = file.stem().string();
      if (!isRunId(id)) {
        throw InputError{fmt::format("{}: expected a name of letters, digits, \".\", \"-\" and \"_\", found others; "
                                     "rename the file",
                                     file.string())};
      }
      recorded.runs.push_back(parseRun(parseJson(readFile(file, largestRun), file.string()), id, file.string()));
    } catch (const InputError& error) {
      recorded.broken.emplace_back(error.what());
    }
  }
  std::stable_sort(recorded.runs.begin(), recorded.runs.end(),
                   [](const Run& a, const Run& b) { return a.time < b.time; });
  return recorded;
}

Run RunFolder::add(Run run) const {
  createFolder(folder_);
  removeAbandonedWrites(folder_);
  const std::string first = makeRunId(run);
  run.id = first;
  for (int again = 2; fs::exists(fileOf(run.id)); ++again) {
    run.id = fmt::format("{}_{}", first, again);
  }
  writeAtomically(fileOf(run.id), runJson(run).dump(1) + "\n");
  return run;
}

bool RunFolder::addCopy(const Run& run) const {
  if (!isRunId(run.id)) {
    throw InputError{
        "a run: expected an id of letters, digits, \".\", \"-\" and \"_\", found others; it is not recorded"};
  }
  createFolder(folder_);
  if (fs::exists(fileOf(run.id))) {
    return false;
  }
  writeAtomically(fileOf(run.id), runJson(run).dump(1) + "\n");
  return true;
}

std::filesystem::path runsIn(const fs::path& state) {
  return state / "runs";
}

} // namespace naocal

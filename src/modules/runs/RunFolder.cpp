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
std::vector<fs::path> listFiles(const fs::path& folder, std::error_code& problem) {
  std::vector<fs::path> files;
  if (!fs::exists(folder, problem)) {
    return files;
  }
  for (fs::directory_iterator entry{folder, problem}, end; !problem && entry != end; entry.increment(problem)) {
    if (entry->path().extension() == ".json" && entry->path().filename().string().front() != '.') {
      files.push_back(entry->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Throws InputError for a name that is no id, and if the file is no run.
Run readRun(const fs::path& file) {
  const std::string id = file.stem().string();
  if (!isRunId(id)) {
    throw InputError{fmt::format("{}: expected a name of letters, digits, \".\", \"-\" and \"_\", found others; "
                                 "rename the file",
                                 file.string())};
  }
  return parseRun(parseJson(readFile(file, largestRun), file.string()), id, file.string());
}

void sortByTime(std::vector<Run>& runs) {
  std::stable_sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.time < b.time; });
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
  std::error_code problem;
  std::vector<fs::path> files = listFiles(folder_, problem);
  if (problem) {
    recorded.broken.push_back(fmt::format("{}: expected a folder of runs that can be read, found a problem: {}",
                                          folder_.string(), problem.message()));
  }
  if (files.size() > most) {
    recorded.broken.push_back(fmt::format("{}: expected at most {} runs, found {}; the oldest are left out",
                                          folder_.string(), most, files.size()));
    files.erase(files.begin(), files.end() - static_cast<std::ptrdiff_t>(most));
  }
  for (const fs::path& file : files) {
    try {
      recorded.runs.push_back(readRun(file));
    } catch (const InputError& error) {
      recorded.broken.emplace_back(error.what());
    }
  }
  sortByTime(recorded.runs);
  return recorded;
}

std::vector<Run> RunFolder::readNewest(std::size_t most, const std::function<bool(const Run&)>& isWanted) const {
  std::vector<Run> newest;
  std::error_code unreadable;
  const std::vector<fs::path> files = listFiles(folder_, unreadable);
  for (auto file = files.rbegin(); file != files.rend() && newest.size() < most; ++file) {
    try {
      if (Run run = readRun(*file); isWanted(run)) {
        newest.push_back(std::move(run));
      }
    } catch (const InputError&) {
      continue; // `read` says what is wrong with it
    }
  }
  std::reverse(newest.begin(), newest.end());
  sortByTime(newest);
  return newest;
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

#include "CaptureFolders.hpp"

#include "data/CaptureSetFile.hpp"
#include "detect/BoardDetector.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <thread>

namespace naocal {

namespace {

/// A path that cannot be looked at holds none: whose reader says what is wrong.
bool isSet(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::exists(folder / "captures.json", ignored);
}

} // namespace

void addSet(const std::string& folder, OpenedSets& opened) {
  CaptureSet set = readCaptureSet(folder, BadCaptures::refuse).set;
  if (std::any_of(set.captures.begin(), set.captures.end(), [](const Capture& one) { return !one.corners; })) {
    detectInSet(set, folder, std::max(1U, std::thread::hardware_concurrency()),
                [](std::size_t, std::size_t) { return true; });
  }
  if (!opened.folders.emplace(set.name, folder).second) {
    throw InputError{fmt::format("two sets are called \"{}\"; rename the folder of one", set.name)};
  }
  opened.inputs.sets.push_back(std::filesystem::weakly_canonical(folder).string());
  opened.inputs.sha256.push_back(sha256(fileContent(std::filesystem::path{folder} / "captures.json")));
  opened.sets.push_back(std::move(set));
}

bool isFolder(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

std::string folderOf(const std::string& written, const std::filesystem::path& document) {
  const std::filesystem::path beside =
      document.parent_path() / std::filesystem::path{written}.lexically_normal().filename();
  for (const std::filesystem::path& folder : {std::filesystem::path{written}, beside}) {
    if (isSet(folder)) {
      return folder.string();
    }
  }
  throw InputError{
      fmt::format("{}: the capture set {} that it was made from is not there any more, nor is {}; open the "
                  "captures themselves",
                  document.string(), written, beside.string())};
}

void addFolder(const std::string& folder, OpenedSets& opened) {
  std::vector<std::string> sets;
  if (!isSet(folder) && isFolder(folder)) {
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator{folder, unreadable}) {
      if (isFolder(entry.path()) && isSet(entry.path())) {
        sets.push_back(entry.path().string());
      }
    }
    std::sort(sets.begin(), sets.end());
  }
  if (sets.empty()) {
    sets.push_back(folder); // whose reader says what is wrong
  }
  for (const std::string& set : sets) {
    addSet(set, opened);
  }
}

} // namespace naocal

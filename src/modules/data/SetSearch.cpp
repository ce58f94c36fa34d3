#include "data/SetSearch.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t mostFolders = 20'000, mostSets = 500; // looked at in one search
constexpr int near = 3, beside = 1, within = 8; // levels below the document's folder, its parent, a named one
constexpr int mostStepsUp = 2;                  // of a relative place

bool isSet(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / "captures.json", ignored);
}

/// Whether the folder holds the captures with this sum.
bool holds(const fs::path& folder, const std::string& sum) {
  try {
    return isSet(folder) && sha256(readFile(folder / "captures.json")) == sum;
  } catch (const InputError&) { // cannot be read
    return false;
  }
}

/// The folder of a document; "." for a bare file name.
fs::path folderOf(const fs::path& document) {
  return document.has_parent_path() ? document.parent_path() : fs::path{"."};
}

/// What is left of a search.
struct Budget {
  std::size_t folders = mostFolders, sets = mostSets;
};

/// Folders below `root`, nearest first, each with its level.
void addFolders(const fs::path& folder, int level, std::deque<std::pair<fs::path, int>>& queue) {
  std::error_code problem;
  std::vector<fs::path> inside;
  for (fs::directory_iterator entry{folder, fs::directory_options::skip_permission_denied, problem}, end;
       !problem && entry != end; entry.increment(problem)) {
    std::error_code ignored;
    if (!entry->is_symlink(ignored) && entry->is_directory(ignored) && inside.size() < mostFolders) {
      inside.push_back(entry->path());
    }
  }
  std::sort(inside.begin(), inside.end());
  for (fs::path& one : inside) {
    queue.emplace_back(std::move(one), level);
  }
}

/// Searches breadth-first for the captures with this sum.
std::optional<fs::path> searchBelow(const fs::path& root, int levels, const std::string& sum, Budget& budget) {
  std::deque<std::pair<fs::path, int>> queue{{root, 0}};
  while (!queue.empty() && budget.folders > 0 && budget.sets > 0) {
    const auto [folder, level] = std::move(queue.front());
    queue.pop_front();
    --budget.folders;
    budget.sets -= isSet(folder) ? 1 : 0;
    if (holds(folder, sum)) {
      return folder;
    }
    if (level < levels) {
      addFolders(folder, level + 1, queue);
    }
  }
  return std::nullopt;
}

std::optional<fs::path> searchAll(const SetSearch& search, const std::string& sum) {
  Budget named;
  for (const fs::path& folder : search.lookIn) {
    if (auto found = searchBelow(folder, within, sum, named)) {
      return found;
    }
  }
  Budget left;
  std::error_code problem;
  const fs::path folder = fs::weakly_canonical(folderOf(search.document), problem);
  if (problem || folder.empty()) {
    return std::nullopt;
  }
  if (auto found = searchBelow(folder, near, sum, left)) {
    return found;
  }
  const bool hasNeighbours = folder.has_parent_path() && folder.parent_path() != folder.root_path();
  return hasNeighbours ? searchBelow(folder.parent_path(), beside, sum, left) : std::nullopt;
}

/// The place, and a set of its name beside the document: what counts without a sum.
std::optional<fs::path> findByName(const fs::path& place, const fs::path& document) {
  const fs::path neighbour = folderOf(document) / place.filename();
  return isSet(place) ? std::optional{place} : isSet(neighbour) ? std::optional{neighbour} : std::nullopt;
}

std::string tellMissing(const fs::path& place, const SetSearch& search) {
  const std::string document = search.document.string();
  std::vector<std::string> named;
  for (const fs::path& folder : search.lookIn) {
    named.push_back(folder.string());
  }
  const std::string searched = named.empty() ? fmt::format("near {}", document)
                                             : fmt::format("near {} or in {}", document, fmt::join(named, ", "));
  return isSet(place)
             ? fmt::format("{}/captures.json has changed since {} was made from it, and the captures as they were are "
                           "not found {}; say where with --look-in FOLDER",
                           place.string(), document, searched)
             : fmt::format("the captures {} that {} was made from are no longer there, nor found {}; say where with "
                           "--look-in FOLDER",
                           place.string(), document, searched);
}

} // namespace

SoughtSet findSet(const NamedSet& set, const SetSearch& search) {
  fs::path place = fs::path{folderOf(search.document) / set.place}.lexically_normal();
  place = place.has_filename() ? place : place.parent_path(); // "a/." is "a/"
  if (set.sha256.empty()) {
    const auto found = findByName(place, search.document);
    return {found, std::nullopt, found ? "" : tellMissing(place, search)};
  }
  if (holds(place, set.sha256)) {
    return {place, std::nullopt, ""};
  }
  const auto found = searchAll(search, set.sha256);
  return {found, !found && isSet(place) ? std::optional{place} : std::nullopt,
          found ? fmt::format("the captures {} were moved: found as they were (by SHA-256) in {}", place.string(),
                              found->string())
                : tellMissing(place, search)};
}

std::string placeFrom(const fs::path& set, const fs::path& folder) {
  std::error_code problem;
  const fs::path whole = fs::weakly_canonical(set, problem);
  const fs::path base = problem ? fs::path{} : fs::weakly_canonical(folder.empty() ? fs::path{"."} : folder, problem);
  if (problem) {
    return fs::absolute(set, problem).string();
  }
  const fs::path relative = whole.lexically_relative(base);
  const auto up = std::count(relative.begin(), relative.end(), "..");
  const bool isNear = !relative.empty() && up <= mostStepsUp && std::distance(base.begin(), base.end()) > up + 1;
  return isNear ? relative.string() : whole.string();
}

} // namespace naocal

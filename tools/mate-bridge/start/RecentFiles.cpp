#include "start/RecentFiles.hpp"

#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "protocol/BoundedJson.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr std::string_view format = "naocal-panel";
constexpr std::uintmax_t largestList = 1 << 20; // [bytes]

bool isThere(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

std::int64_t now() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Texts of a list, without those that are empty, too long, or no texts.
std::vector<std::string> texts(const Json& list, std::size_t most) {
  std::vector<std::string> result;
  for (const Json& entry : list.is_array() ? list : Json::array()) {
    const auto* const text = entry.get_ptr<const std::string*>();
    if (text != nullptr && !text->empty() && text->size() <= RecentFiles::longestPath && result.size() < most) {
      result.push_back(*text);
    }
  }
  return result;
}

/// An entry of the list; absent if it cannot be understood.
std::optional<RecentFile> parseEntry(const Json& entry) {
  if (!entry.is_object() || !entry.contains("paths") || !entry["paths"].is_array()) {
    return std::nullopt;
  }
  const std::vector<std::string> paths = texts(entry["paths"], RecentFiles::mostPaths);
  if (paths.empty() || paths.size() != entry["paths"].size()) {
    return std::nullopt;
  }
  const Json opened = entry.value("opened", Json());
  return RecentFile{paths, opened.is_number_integer() ? opened.get<std::int64_t>() : 0};
}

std::filesystem::path absolutePath(const char* variable) {
  const char* const given = std::getenv(variable);
  const std::filesystem::path path = given == nullptr ? "" : given;
  return path.is_absolute() ? path : "";
}

} // namespace

RecentFiles::RecentFiles(std::filesystem::path file) : file_{std::move(file)} {
  read();
}

void RecentFiles::read() {
  problem_.clear();
  std::error_code ignored;
  if (file_.empty() || !std::filesystem::exists(file_, ignored)) {
    return;
  }
  try {
    const Json document = parseBoundedJson(readFile(file_, largestList));
    if (!document.is_object() || document.value("format", Json()) != format) {
      problem_ = fmt::format("{} holds something else than recently opened files; move it away to keep the list",
                             file_.string());
      return;
    }
    files_.clear();
    const Json list = document.value("recent", Json::array());
    for (const Json& entry : list.is_array() ? list : Json::array()) {
      if (auto parsed = parseEntry(entry); parsed && files_.size() < mostFiles) {
        files_.push_back(std::move(*parsed));
      }
    }
    robots_ = texts(document.value("robots", Json::array()), mostRobots);
  } catch (const std::exception& error) { // unreadable, or no JSON
    problem_ = fmt::format("{} cannot be read as a list of recently opened files ({}); move it away to keep the list",
                           file_.string(), parseErrorReason(error));
  }
}

void RecentFiles::write() {
  if (file_.empty() || !problem_.empty()) {
    return;
  }
  Json recent = Json::array();
  for (const RecentFile& entry : files_) {
    recent.push_back({{"paths", entry.paths}, {"opened", entry.opened}});
  }
  const Json document = withFormat(format, {{"recent", recent}, {"robots", robots_}});
  try {
    std::filesystem::create_directories(file_.parent_path());
    writeAtomically(file_, jsonLine(document));
  } catch (const std::exception& error) { // a full disk must not keep captures from being opened
    problem_ = fmt::format("the list of recently opened files is not kept: {}", error.what());
  }
}

void RecentFiles::add(const std::vector<std::string>& paths) {
  read();
  std::vector<std::string> absolute;
  for (const std::string& path : paths) {
    absolute.push_back(std::filesystem::absolute(path).lexically_normal().string());
  }
  if (absolute.empty() || absolute.size() > mostPaths) {
    return;
  }
  std::erase_if(files_, [&](const RecentFile& entry) {
    return entry.paths == absolute || !std::all_of(entry.paths.begin(), entry.paths.end(), isThere);
  });
  files_.insert(files_.begin(), {absolute, now()});
  files_.resize(std::min(files_.size(), mostFiles));
  write();
}

void RecentFiles::forget(const std::vector<std::string>& paths) {
  read();
  std::erase_if(files_, [&](const RecentFile& entry) { return entry.paths == paths; });
  write();
}

void RecentFiles::setRobots(const std::vector<std::string>& addresses) {
  read();
  robots_.clear();
  for (const std::string& address : addresses) {
    if (robots_.size() < mostRobots && std::find(robots_.begin(), robots_.end(), address) == robots_.end()) {
      robots_.push_back(address);
    }
  }
  write();
}

std::vector<RecentFile> RecentFiles::files() const {
  std::vector<RecentFile> there;
  std::copy_if(files_.begin(), files_.end(), std::back_inserter(there),
               [](const RecentFile& entry) { return std::all_of(entry.paths.begin(), entry.paths.end(), isThere); });
  return there;
}

std::string kindOfDataset(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::path place{path};
  if (std::filesystem::is_directory(place, ignored)) {
    const bool isRecording = std::filesystem::exists(place / "offsets.json", ignored) ||
                             std::filesystem::exists(place / "first" / "offsets.json", ignored);
    return isRecording                                                 ? "recording"
           : std::filesystem::exists(place / "captures.json", ignored) ? "capture set"
                                                                       : "capture sets";
  }
  std::string head(std::size_t{1} << 20, '\0');
  if (std::filesystem::is_regular_file(place, ignored)) {
    std::ifstream{place}.read(head.data(), std::streamsize(head.size()));
  }
  constexpr std::array<std::string_view, 4> kinds{"result", "diagnosis", "session", "model"};
  for (const std::string_view kind : kinds) {
    if (head.find(fmt::format("\"naocal-{}\"", kind)) != std::string::npos) {
      return std::string{kind};
    }
  }
  return "file";
}

std::filesystem::path recentFilesFile() {
  if (const auto state = absolutePath("XDG_STATE_HOME"); !state.empty()) {
    return state / "naocal" / "panel.json";
  }
  const auto home = absolutePath("HOME");
  return home.empty() ? home : home / ".local" / "state" / "naocal" / "panel.json";
}

} // namespace naocal

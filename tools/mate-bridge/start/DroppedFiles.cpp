#include "start/DroppedFiles.hpp"

#include "io/InputError.hpp"
#include "start/DroppedKinds.hpp"
#include "start/RecentFiles.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace naocal {

namespace {

/// Throws InputError unless the name is a relative path within a folder.
void requireName(const std::string& name) {
  std::size_t folders = 0;
  std::istringstream parts{name};
  bool isGood = !name.empty() && name.back() != '/';
  for (std::string part; std::getline(parts, part, '/'); ++folders) {
    isGood = isGood && !part.empty() && part != "." && part != ".." && part.size() <= DroppedFiles::longestName &&
             std::none_of(part.begin(), part.end(), [](unsigned char letter) { return letter < 32 || letter == 127; });
  }
  if (!isGood || folders > DroppedFiles::mostFolders + 1) {
    throw InputError{fmt::format("dropped files: expected names within at most {} folders, without control characters "
                                 "and \"..\", found \"{}\"; drop the folder of the captures",
                                 DroppedFiles::mostFolders, name)};
  }
}

/// Throws InputError unless the file is a document, a table, a robot's description, a lens or a picture.
void requireKind(const std::string& name) {
  if (!droppedKindOf(name)) {
    throw InputError{fmt::format("dropped files: expected names that end in {}, found \"{}\"; leave it out",
                                 droppedEndings(), name)};
  }
}

bool isCaptureSet(const std::string& name) {
  return std::filesystem::path{name}.filename() == "captures.json";
}

bool isDocument(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".json") && !isDroppedTruth(name) && !isCaptureSet(name);
}

} // namespace

DroppedFiles::DroppedFiles(const nlohmann::json& announced, const Amount& before) {
  if (!announced.is_array() || announced.empty() || announced.size() + before.files > mostFiles) {
    throw InputError{
        fmt::format("dropped files: expected 1 to {} files, found {}", mostFiles, announced.size() + before.files)};
  }
  std::set<std::string> names;
  std::uintmax_t all = before.bytes;
  for (const nlohmann::json& entry : announced) {
    File file{entry.at("name"), entry.at("bytes")};
    requireName(file.name);
    requireKind(file.name);
    if (!names.insert(file.name).second) {
      throw InputError{fmt::format("dropped files: expected every name once, found \"{}\" twice", file.name)};
    }
    if (!entry.at("bytes").is_number_unsigned() || file.bytes > mostBytes || (all += file.bytes) > mostBytes) {
      throw InputError{fmt::format("dropped files: expected at most {} MB together, found more; start mate-bridge with "
                                   "the folder, or type its path",
                                   mostBytes >> 20)};
    }
    files_.push_back(std::move(file));
  }
  startFiles();
}

/// Creates files up to the next one that is not empty.
void DroppedFiles::startFiles() {
  for (; next_ < files_.size(); ++next_) {
    const std::filesystem::path file = folder_.path() / files_[next_].name;
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    output_ = std::ofstream{file, std::ios::binary};
    if (error || !output_) {
      throw InputError{fmt::format("{}: cannot be written into a temporary folder; is there room, and is no folder "
                                   "called like a file?",
                                   files_[next_].name)};
    }
    left_ = files_[next_].bytes;
    if (left_ > 0) {
      return;
    }
  }
}

void DroppedFiles::append(std::string_view part) {
  while (!part.empty()) {
    if (isComplete()) {
      throw InputError{"dropped files: expected no more bytes than announced, found more; drop them again"};
    }
    const std::size_t count = std::min<std::uintmax_t>(part.size(), left_);
    output_.write(part.data(), std::streamsize(count));
    part.remove_prefix(count);
    received_ += count;
    left_ -= count;
    if (left_ == 0) {
      output_.close();
    }
    if (!output_) {
      throw InputError{fmt::format("{}: cannot be written into {}; is there room?", files_[next_].name,
                                   folder_.path().parent_path().string())};
    }
    if (left_ == 0) {
      ++next_;
      startFiles();
    }
  }
}

std::vector<std::string> DroppedFiles::names() const {
  std::vector<std::string> names;
  for (const File& file : files_) {
    names.push_back(file.name);
  }
  return names;
}

DroppedFiles::Amount DroppedFiles::amount() const {
  Amount amount{files_.size(), 0};
  for (const File& file : files_) {
    amount.bytes += file.bytes;
  }
  return amount;
}

bool DroppedFiles::holdsSet() const {
  return std::any_of(files_.begin(), files_.end(), [](const File& file) { return isCaptureSet(file.name); });
}

bool DroppedFiles::holdsImport() const {
  return !holdsSet() && std::any_of(files_.begin(), files_.end(), [](const File& file) {
    const auto kind = droppedKindOf(file.name);
    return kind == DroppedKind::table || kind == DroppedKind::robot;
  });
}

void DroppedFiles::add(DroppedFiles& further) {
  std::set<std::string> replaced;
  for (const File& file : further.files_) {
    const std::filesystem::path to = folder_.path() / file.name;
    std::error_code error;
    std::filesystem::create_directories(to.parent_path(), error);
    if (!error) {
      std::filesystem::rename(further.folder_.path() / file.name, to, error);
    }
    if (error) {
      throw InputError{fmt::format("{}: cannot be put beside the files that were dropped before; is there room, and is "
                                   "no folder called like a file?",
                                   file.name)};
    }
    replaced.insert(file.name);
  }
  std::erase_if(files_, [&](const File& file) { return replaced.contains(file.name); });
  files_.insert(files_.end(), further.files_.begin(), further.files_.end());
  next_ = files_.size();
}

std::vector<std::string> DroppedFiles::paths() const {
  std::vector<std::string> folders, documents;
  if (std::filesystem::exists(folder_.path() / "captures.json")) {
    folders.push_back(folder_.path().string());
  }
  for (const auto& entry : std::filesystem::directory_iterator{folder_.path()}) {
    if (entry.is_directory() && (folders.empty() || folders.front() != folder_.path())) {
      folders.push_back(entry.path().string());
    } else if (entry.is_regular_file() && isDocument(entry.path())) {
      documents.push_back(entry.path().string());
    }
  }
  std::sort(folders.begin(), folders.end());
  std::sort(documents.begin(), documents.end());
  const auto result = std::find_if(documents.begin(), documents.end(),
                                   [](const std::string& document) { return kindOfDataset(document) == "result"; });
  if (result != documents.end()) {
    return {*result};
  }
  folders.insert(folders.end(), documents.begin(), documents.end());
  if (folders.empty()) {
    throw InputError{fmt::format("dropped files: expected {}, found none", expectedDrop)};
  }
  return folders;
}

} // namespace naocal

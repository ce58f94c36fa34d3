#pragma once

#include <algorithm>
#include <cstdarg>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

/// Include it in one file of a program only: it replaces functions of the C library.
namespace naocal {

/// What a disk may hold after a power failure. Records what this program asks the kernel to write below a folder, and
/// lists all states that POSIX allows if the power fails after any of these requests:
///
///   * of data that no fsync of its file has confirmed, nothing, a half, the file's length without the data, or all;
///   * of the names that no fsync of their folder has confirmed (created, renamed, removed, new folders), any subset,
///   each
///     as a whole.
///
/// Recording is for one thread; other threads must not write below the folder.
class PowerLoss {
public:
  /// A state: content by path relative to the folder; folders have none.
  using State = std::map<std::string, std::optional<std::string>>;

  /// Records while `action` runs. `folder` exists and is empty or holds files that are durable.
  PowerLoss(const std::filesystem::path& folder, const std::function<void()>& action);

  /// States after the first `requests` requests, without duplicates.
  std::set<State> statesAfter(std::size_t requests) const;
  std::size_t requests() const { return requests_.size(); }

  /// Writes a state into an empty folder.
  static void restore(const State& state, const std::filesystem::path& folder);

  struct Request {
    enum class Kind { create, write, syncFile, syncFolder, rename, remove, makeFolder } kind;
    std::string path, other; // relative; other: new name
    std::size_t file = 0;    // number of the file
    std::string bytes;
  };

private:
  struct File {
    std::string durable, written; // content
  };
  /// A change of a folder's names: path -> number of a file or `noFile`; nothing: removed.
  struct Change {
    std::string folder;
    std::vector<std::pair<std::string, std::optional<std::size_t>>> names;
  };
  static constexpr std::size_t folderMark = std::size_t(-1);

  void addStates(const std::vector<File>& files, const std::map<std::string, std::size_t>& durable,
                 const std::vector<Change>& changes, std::set<State>& states) const;

  std::vector<Request> requests_;
  std::map<std::string, std::size_t> names_; // before, by path
  std::vector<File> files_;                  // before
};

namespace powerLoss {

/// The recording that runs; nullptr: none.
struct Recording {
  std::string root;
  std::vector<PowerLoss::Request> requests;
  std::map<std::string, std::size_t> files;         // numbers, by present path
  std::map<int, std::pair<std::string, bool>> open; // path and whether it is a folder, by descriptor
  std::map<int, std::size_t> fileOf;                // number, by descriptor
  std::size_t next = 0;

  std::optional<std::string> inside(const std::string& path) const {
    const std::string start = root + "/";
    return path.starts_with(start) ? std::optional{path.substr(start.size())}
           : path == root          ? std::optional{std::string{}}
                                   : std::nullopt;
  }
};
inline Recording* recording = nullptr;

template <class Function> Function* next(const char* name) {
  static_assert(sizeof(void*) == sizeof(Function*));
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

inline void noteRemoval(const char* path) {
  if (const auto inside = recording->inside(path)) {
    recording->requests.push_back({PowerLoss::Request::Kind::remove, *inside, "", 0, ""});
    recording->files.erase(*inside);
  }
}

} // namespace powerLoss

inline PowerLoss::PowerLoss(const std::filesystem::path& folder, const std::function<void()>& action) {
  powerLoss::Recording recording;
  recording.root = std::filesystem::canonical(folder).string();
  for (const auto& entry : std::filesystem::recursive_directory_iterator{recording.root}) {
    const std::string path = entry.path().lexically_relative(recording.root).string();
    if (entry.is_directory()) {
      names_[path] = folderMark;
      continue;
    }
    std::ifstream stream{entry.path(), std::ios::binary};
    const std::string content{std::istreambuf_iterator<char>{stream}, {}};
    names_[path] = recording.files[path] = recording.next++;
    files_.push_back({content, content});
  }
  powerLoss::recording = &recording;
  try {
    action();
  } catch (...) {
    powerLoss::recording = nullptr;
    throw;
  }
  powerLoss::recording = nullptr;
  requests_ = std::move(recording.requests);
}

inline std::set<PowerLoss::State> PowerLoss::statesAfter(std::size_t requests) const {
  using Kind = Request::Kind;
  std::vector<File> files = files_;
  std::map<std::string, std::size_t> durable = names_, present = names_;
  std::vector<Change> changes; // not durable yet
  const auto change = [&](const std::string& path,
                          std::vector<std::pair<std::string, std::optional<std::size_t>>> names) {
    for (const auto& [name, file] : names) {
      file ? void(present[name] = *file) : void(present.erase(name));
    }
    changes.push_back({std::filesystem::path{path}.parent_path().string(), std::move(names)});
  };
  for (std::size_t i = 0; i < requests; ++i) {
    const Request& request = requests_[i];
    switch (request.kind) {
    case Kind::create:
      files.resize(std::max(files.size(), request.file + 1));
      change(request.path, {{request.path, request.file}});
      break;
    case Kind::write:
      files[request.file].written += request.bytes;
      break;
    case Kind::syncFile:
      files[request.file].durable = files[request.file].written;
      break;
    case Kind::rename:
      change(request.path, {{request.other, present.at(request.path)}, {request.path, std::nullopt}});
      break;
    case Kind::remove:
      change(request.path, {{request.path, std::nullopt}});
      break;
    case Kind::makeFolder:
      change(request.path, {{request.path, folderMark}});
      break;
    case Kind::syncFolder:
      std::erase_if(changes, [&](const Change& one) {
        for (const auto& [name, file] : one.names) {
          if (one.folder == request.path) {
            file ? void(durable[name] = *file) : void(durable.erase(name));
          }
        }
        return one.folder == request.path;
      });
      break;
    }
  }
  std::set<State> states;
  addStates(files, durable, changes, states);
  return states;
}

inline void PowerLoss::addStates(const std::vector<File>& files, const std::map<std::string, std::size_t>& durable,
                                 const std::vector<Change>& changes, std::set<State>& states) const {
  constexpr std::size_t most = 12; // changes that are not durable
  if (changes.size() > most) {
    throw std::logic_error{"too many names are not durable to list all states"};
  }
  for (std::size_t subset = 0; subset < std::size_t{1} << changes.size(); ++subset) {
    std::map<std::string, std::size_t> names = durable;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      for (const auto& [name, file] : changes[i].names) {
        if ((subset >> i & 1) != 0) {
          file ? void(names[name] = *file) : void(names.erase(name));
        }
      }
    }
    for (int content = 0; content < 4; ++content) {
      State state;
      for (const auto& [name, file] : names) {
        bool isReachable = true; // all folders above it are there
        for (auto above = std::filesystem::path{name}.parent_path(); !above.empty(); above = above.parent_path()) {
          isReachable = isReachable && names.contains(above.string());
        }
        if (!isReachable) {
          continue;
        }
        if (file == folderMark) {
          state[name];
          continue;
        }
        const auto& [kept, written] = files[file];
        const std::string rest = written.substr(std::min(kept.size(), written.size()));
        state[name] = content == 0   ? kept
                      : content == 1 ? kept + rest.substr(0, rest.size() / 2)
                      : content == 2 ? kept + std::string(rest.size(), '\0')
                                     : written;
      }
      states.insert(std::move(state));
    }
  }
}

inline void PowerLoss::restore(const State& state, const std::filesystem::path& folder) {
  for (const auto& [path, content] : state) { // folders come before what is in them
    if (content) {
      std::ofstream{folder / path, std::ios::binary} << *content;
    } else {
      std::filesystem::create_directory(folder / path);
    }
  }
}

} // namespace naocal

extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  static auto* const original = naocal::powerLoss::next<int(const char*, int, ...)>("open");
  auto* const recording = naocal::powerLoss::recording;
  struct stat status {};
  const bool existed = recording != nullptr && ::stat(path, &status) == 0;
  const int file = original(path, flags, mode);
  const auto inside = recording != nullptr && file >= 0 ? recording->inside(path) : std::nullopt;
  if (inside) {
    recording->open[file] = {*inside, existed && S_ISDIR(status.st_mode)};
    if ((flags & O_CREAT) != 0 && !existed) {
      recording->files[*inside] = recording->next;
      recording->requests.push_back({naocal::PowerLoss::Request::Kind::create, *inside, "", recording->next++, ""});
    }
    if (const auto known = recording->files.find(*inside); known != recording->files.end()) {
      recording->fileOf[file] = known->second;
    }
  }
  return file;
}

ssize_t write(int file, const void* bytes, size_t count) {
  static auto* const original = naocal::powerLoss::next<ssize_t(int, const void*, size_t)>("write");
  const ssize_t written = original(file, bytes, count);
  auto* const recording = naocal::powerLoss::recording;
  if (recording != nullptr && written > 0 && recording->fileOf.contains(file)) {
    recording->requests.push_back({naocal::PowerLoss::Request::Kind::write, "", "", recording->fileOf[file],
                                   std::string{static_cast<const char*>(bytes), std::size_t(written)}});
  }
  return written;
}

int fsync(int file) {
  static auto* const original = naocal::powerLoss::next<int(int)>("fsync");
  const int result = original(file);
  auto* const recording = naocal::powerLoss::recording;
  if (recording != nullptr && result == 0 && recording->open.contains(file)) {
    using Kind = naocal::PowerLoss::Request::Kind;
    const auto& [path, isFolder] = recording->open[file];
    recording->requests.push_back(
        {isFolder ? Kind::syncFolder : Kind::syncFile, path, "", isFolder ? 0 : recording->fileOf.at(file), ""});
  }
  return result;
}

int close(int file) {
  static auto* const original = naocal::powerLoss::next<int(int)>("close");
  if (auto* const recording = naocal::powerLoss::recording) {
    recording->open.erase(file);
    recording->fileOf.erase(file);
  }
  return original(file);
}

int rename(const char* from, const char* to) noexcept {
  static auto* const original = naocal::powerLoss::next<int(const char*, const char*)>("rename");
  const int result = original(from, to);
  auto* const recording = naocal::powerLoss::recording;
  const auto inside = recording != nullptr && result == 0 ? recording->inside(from) : std::nullopt;
  if (inside) {
    const std::string other = recording->inside(to).value();
    recording->requests.push_back({naocal::PowerLoss::Request::Kind::rename, *inside, other, 0, ""});
    recording->files[other] = recording->files.at(*inside);
    recording->files.erase(*inside);
  }
  return result;
}

int unlink(const char* path) noexcept {
  static auto* const original = naocal::powerLoss::next<int(const char*)>("unlink");
  const int result = original(path);
  if (naocal::powerLoss::recording != nullptr && result == 0) {
    naocal::powerLoss::noteRemoval(path);
  }
  return result;
}

int remove(const char* path) noexcept {
  static auto* const original = naocal::powerLoss::next<int(const char*)>("remove");
  const int result = original(path);
  if (naocal::powerLoss::recording != nullptr && result == 0) {
    naocal::powerLoss::noteRemoval(path);
  }
  return result;
}

int mkdir(const char* path, mode_t mode) noexcept {
  static auto* const original = naocal::powerLoss::next<int(const char*, mode_t)>("mkdir");
  const int result = original(path, mode);
  auto* const recording = naocal::powerLoss::recording;
  const auto inside = recording != nullptr && result == 0 ? recording->inside(path) : std::nullopt;
  if (inside) {
    recording->requests.push_back({naocal::PowerLoss::Request::Kind::makeFolder, *inside, "", 0, ""});
  }
  return result;
}

} // extern "C"

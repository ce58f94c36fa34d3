#pragma once

#include "framework/configuration/AtomicWrite.hpp"
#include "framework/configuration/ConfigurationLayers.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// The configuration of one robot: files served under mount names, merged from layers, changed by key, and saved into
/// the robot's own layers; shipped files stay untouched. Thread-safe.
class Configuration {
public:
  /// Validates a top-level key's new value before it takes effect; throws ConfigurationError to refuse it.
  using Listener = std::function<void(const std::string& key, const nlohmann::json& value)>;

  /// Completes an interrupted save; writes a sentence to `log` if the journal is not valid for this robot.
  Configuration(
      ConfigurationFolders folders, RobotNames names, FileWriter writer,
      const std::function<void(std::string_view)>& log = [](std::string_view) {});
  ~Configuration();

  /// Serves the keys of `file` as `mount`; never saves the keys in `unsaved`. Throws ConfigurationError for a broken
  /// file or a mount name already taken.
  void mount(const std::string& mount, const std::string& file, RobotPart part, Listener listener = {},
             std::set<std::string> unsaved = {});

  /// Serves a read-only key that is in no file (NaoInfo.headName).
  void publish(const std::string& mount, const std::string& key, const nlohmann::json& value);

  struct Mount {
    std::string name;
    std::filesystem::path file; // most specific existing file; without one, the save target
  };
  std::vector<Mount> mounts() const;

  /// All keys of a mount; an empty object for an unknown mount.
  void readKeys(std::string_view mount, nlohmann::json& out) const;

  /// Sets the value at a path such as `a.b[2].c`. Lists cannot grow, keys must exist, and a key may contain dots.
  /// Throws ConfigurationError if the path does not exist or the listener refuses the value; the configuration then
  /// stays unchanged.
  void set(std::string_view mount, std::string_view path, const nlohmann::json& value);

  /// Writes all changes since the last save into the robot's own files (`saveTarget`) and keeps their other keys; the
  /// previous version of each file is kept as `<file>.previous`. Files whose content would not change are not written,
  /// so that undo reverts the last effective save. Atomic: after a crash all files are old or all are new.
  void save();
  /// Saves only this mount, and the mounts grouped with it (`saveTogether`).
  void save(const std::string& mount);

  /// Groups mounts: a save or undo of one of them applies to all, changed or not.
  void saveTogether(std::vector<std::string> mounts);

  /// Number of saves so far that were asked for.
  std::size_t saveCount() const { return saveCount_; }

  /// No unsaved changes: every key has the value in the files.
  bool isSaved(std::string_view mount) const;

  /// Writes all files, as they would be after saving now, into another, empty root. Merges shipped and saved files;
  /// leaves out what else lies in the folder of saved ones, the secret (access.json) and the journal of an interrupted
  /// save.
  void writeTo(const std::filesystem::path& root) const;

  /// Restores a mount's saved file, and its keys, from before the last save; unsaved changes are lost. Throws
  /// ConfigurationError if nothing was saved since the last undo.
  void undo(const std::string& mount);

  /// Save target of a mount: the robot's own file of the default location, which applies at every location; its file of
  /// the current location if that location already sets keys of this mount.
  std::filesystem::path saveTarget(std::string_view mount) const;

private:
  struct Mounted;
  Mounted& mounted(std::string_view mount);
  const Mounted& mounted(std::string_view mount) const;
  std::filesystem::path target(const Mounted& mounted) const;
  std::filesystem::path journal() const;
  nlohmann::json toSave(const Mounted& mounted) const; // content of the saved file
  nlohmann::json merged(const std::filesystem::path& file,
                        const std::map<std::filesystem::path, nlohmann::json>& changed) const; // shipped and saved
  std::vector<Mounted*> keptTogether(const std::string& mount);
  bool changesFile(const Mounted& mounted) const;
  void save(const std::set<std::vector<Mounted*>>& groups);

  ConfigurationFolders folders_;
  RobotNames names_;
  FileWriter writer_;
  mutable std::mutex mutex_;
  std::map<std::string, std::unique_ptr<Mounted>, std::less<>> mounts_;
  std::vector<std::vector<std::string>> together_; // mounts
  std::atomic<std::size_t> saveCount_ = 0;
};

} // namespace naocal

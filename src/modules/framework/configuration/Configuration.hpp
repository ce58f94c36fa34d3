#pragma once

#include "framework/configuration/AtomicWrite.hpp"
#include "framework/configuration/ConfigurationLayers.hpp"

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// The configuration of one robot: files under mount names, read through their layers, changed by key, saved into the
/// layer of the robot that they belong to, beside what was shipped. All functions may be called from any thread.
class Configuration {
public:
  /// Is given a top-level key's new value before it counts, and throws ConfigurationError to refuse it.
  using Listener = std::function<void(const std::string& key, const nlohmann::json& value)>;

  /// Finishes a save that was cut off; says to `log` where it does not, because its journal is not this robot's.
  Configuration(
      ConfigurationFolders folders, RobotNames names, FileWriter writer,
      const std::function<void(std::string_view)>& log = [](std::string_view) {});
  ~Configuration();

  /// Serves a file's keys as `mount`; those of `unsaved` are never saved. Throws ConfigurationError for a broken file
  /// or a mount name that is taken.
  void mount(const std::string& mount, const std::string& file, RobotPart part, Listener listener = {},
             std::set<std::string> unsaved = {});

  /// Serves a key that is in no file and cannot be set (NaoInfo.headName).
  void publish(const std::string& mount, const std::string& key, const nlohmann::json& value);

  struct Mount {
    std::string name;
    std::filesystem::path file; // the most specific one that exists; where it would be saved when there is none
  };
  std::vector<Mount> mounts() const;

  /// All keys of a mount; an empty object for one that does not exist.
  void readKeys(std::string_view mount, nlohmann::json& out) const;

  /// Sets the value at a path such as `a.b[2].c` (lists cannot grow, keys must exist, a key may hold dots itself).
  /// Throws ConfigurationError when there is no such place or its module refuses the value; nothing has changed then.
  void set(std::string_view mount, std::string_view path, const nlohmann::json& value);

  /// Writes what was set since the last save into the robot's own files (saveTarget), the file's other keys as they
  /// are; the file as it was is kept beside it as `<file>.previous`. Where no content would change, nothing is written,
  /// and an undo takes back the save before. Whatever ends the program, all files are old or all new.
  void save();
  /// Only this mount.
  void save(const std::string& mount);

  /// From now on a save or an undo of one of these mounts is one of all of them, changed or not: what belongs together
  /// goes back together.
  void saveTogether(std::vector<std::string> mounts);

  /// All is as the files say: nothing was set since the last save, or it was put back.
  bool isSaved(std::string_view mount) const;

  /// Writes all files as they would be if everything was saved now into another, empty root, where what was shipped and
  /// what was saved are one, without the secret and without what a save that did not end has noted.
  void writeTo(const std::filesystem::path& root) const;

  /// Puts a mount's saved file back to what it was before its last save, and its keys with it. Changes that are not
  /// saved are lost. Throws ConfigurationError when nothing was saved since the last undo.
  void undo(const std::string& mount);

  /// Where a mount's changes are saved: the robot's own file of the default location, so that a robot keeps them
  /// wherever it plays; its file of the present location when that location sets keys of this mount already.
  std::filesystem::path saveTarget(std::string_view mount) const;

private:
  struct Mounted;
  Mounted& mounted(std::string_view mount);
  const Mounted& mounted(std::string_view mount) const;
  std::filesystem::path target(const Mounted& mounted) const;
  std::filesystem::path journal() const;
  nlohmann::json toSave(const Mounted& mounted) const; // its file's content
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
};

} // namespace naocal

#include "framework/configuration/Configuration.hpp"

#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/configuration/JsonPath.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using nlohmann::json;

std::filesystem::path previousOf(const std::filesystem::path& file) {
  return file.string() + ".previous";
}

std::string text(const json& object) {
  return object.dump(2) + "\n";
}

constexpr const char* journalName = "unfinished-save.json";

/// All files of a configuration, by relative path, without the secret and the journal; empty if `root` does not exist.
std::set<std::filesystem::path> filesIn(const std::filesystem::path& root) {
  std::set<std::filesystem::path> files;
  if (!std::filesystem::exists(root)) {
    return files;
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator{root}) {
    const auto& file = entry.path();
    if (entry.is_regular_file() && file.extension() == ".json" && file.filename() != "access.json" &&
        file.filename() != journalName) {
      files.insert(file.lexically_relative(root));
    }
  }
  return files;
}

/// The bytes of a file, including comments; an empty object if it does not exist.
std::string textOf(const std::filesystem::path& file) {
  return readConfigurationText(file).value_or("{}\n");
}

} // namespace

/// A mounted file: layers, published keys and unsaved changes.
struct Configuration::Mounted {
  std::string name;
  std::string file;
  RobotPart part = RobotPart::none;
  Listener listener;
  std::set<std::string> unsaved; // top-level keys never written to a file
  Overlay overlay;
  nlohmann::json published = nlohmann::json::object();
  std::map<std::string, nlohmann::json> changed; // unsaved top-level keys and their values in the files
};

Configuration::Configuration(ConfigurationFolders folders, RobotNames names, FileWriter writer,
                             const std::function<void(std::string_view)>& log)
    : folders_{std::move(folders)}, names_{std::move(names)}, writer_{std::move(writer)} {
  if (const std::string refused = recoverWrites(journal(), folders_.saved, writer_); !refused.empty()) {
    log(refused);
  }
}
Configuration::~Configuration() = default;

void Configuration::mount(const std::string& mount, const std::string& file, RobotPart part, Listener listener,
                          std::set<std::string> unsaved) {
  Overlay overlay{layerFiles(folders_, file, part, names_)};
  const std::lock_guard lock{mutex_};
  const auto [place, isNew] = mounts_.try_emplace(mount);
  if (!isNew) {
    throw ConfigurationError{fmt::format("{} is mounted twice; give one of the two modules another name", mount)};
  }
  place->second.reset(new Mounted{mount, file, part, std::move(listener), std::move(unsaved), std::move(overlay)});
}

void Configuration::publish(const std::string& mount, const std::string& key, const json& value) {
  const std::lock_guard lock{mutex_};
  mounted(mount).published[key] = value;
}

const Configuration::Mounted& Configuration::mounted(std::string_view mount) const {
  const auto entry = mounts_.find(mount);
  if (entry == mounts_.end()) {
    throw ConfigurationError{fmt::format("there is no mount {}; ask for the list of mounts", mount)};
  }
  return *entry->second;
}

Configuration::Mounted& Configuration::mounted(std::string_view mount) {
  return const_cast<Mounted&>(std::as_const(*this).mounted(mount));
}

std::vector<Configuration::Mount> Configuration::mounts() const {
  const std::lock_guard lock{mutex_};
  std::vector<Mount> all;
  for (const auto& [name, entry] : mounts_) {
    all.push_back({name, entry->overlay.last.value_or(target(*entry))});
  }
  return all;
}

void Configuration::readKeys(std::string_view mount, json& out) const {
  const std::lock_guard lock{mutex_};
  out = json::object();
  if (const auto entry = mounts_.find(mount); entry != mounts_.end()) {
    out = *entry->second->overlay.merged;
    out.update(entry->second->published);
  }
}

void Configuration::set(std::string_view mount, std::string_view path, const json& value) {
  const std::lock_guard lock{mutex_};
  Mounted& entry = mounted(mount);
  json changed = *entry.overlay.merged;
  const auto place = resolvePath(changed, path);
  if (place.value == nullptr) {
    throw ConfigurationError{
        fmt::format("{}: there is no {} to set; keys cannot be added and lists cannot grow", mount, path)};
  }
  *place.value = value;
  if (entry.listener) {
    entry.listener(place.topLevelKey, changed[place.topLevelKey]);
  }
  json& present = (*entry.overlay.merged)[place.topLevelKey];
  if (!entry.unsaved.contains(place.topLevelKey)) {
    const auto before = entry.changed.try_emplace(place.topLevelKey, present).first;
    if (before->second == changed[place.topLevelKey]) {
      entry.changed.erase(before);
    }
  }
  present = std::move(changed[place.topLevelKey]);
}

std::filesystem::path Configuration::target(const Mounted& entry) const {
  const auto layers = layerFiles(folders_, entry.file, entry.part, names_);
  const std::size_t perLocation = (entry.part == RobotPart::none ? 1 : 3) * (folders_.areTwo() ? 2 : 1);
  for (std::size_t i = perLocation; i < layers.size(); ++i) {
    for (const auto& [key, origin] : entry.overlay.origins) {
      if (origin == layers[i]) {
        return layers.back();
      }
    }
  }
  return layers[perLocation - 1];
}

std::filesystem::path Configuration::saveTarget(std::string_view mount) const {
  const std::lock_guard lock{mutex_};
  return target(mounted(mount));
}

std::filesystem::path Configuration::journal() const {
  return folders_.saved / "location" / journalName;
}

json Configuration::toSave(const Mounted& entry) const {
  json content = readConfiguration(target(entry)).value_or(json::object());
  for (const auto& [key, before] : entry.changed) {
    content[key] = (*entry.overlay.merged)[key];
  }
  return content;
}

bool Configuration::changesFile(const Mounted& entry) const {
  return !entry.changed.empty() && toSave(entry) != readConfiguration(target(entry)).value_or(json::object());
}

void Configuration::save(const std::set<std::vector<Mounted*>>& groups) {
  std::vector<FileContent> files;
  std::vector<Mounted*> written;
  for (const auto& group : groups) {
    if (std::none_of(group.begin(), group.end(), [this](const Mounted* entry) { return changesFile(*entry); })) {
      continue; // nothing to write; the undo state stays
    }
    for (Mounted* entry : group) {
      const auto file = target(*entry);
      const std::string present = textOf(file);
      files.push_back({previousOf(file), present});
      files.push_back({file, entry->changed.empty() ? present : text(toSave(*entry))});
      written.push_back(entry);
    }
  }
  writeFilesAtomically(journal(), folders_.saved, files, writer_);
  for (Mounted* entry : written) {
    const auto file = target(*entry);
    for (const auto& [key, before] : entry->changed) {
      entry->overlay.origins[key] = file;
    }
    entry->overlay.last = file;
  }
  for (const auto& group : groups) {
    for (Mounted* entry : group) {
      entry->changed.clear();
    }
  }
  ++saveCount_;
}

void Configuration::saveTogether(std::vector<std::string> mounts) {
  const std::lock_guard lock{mutex_};
  together_.push_back(std::move(mounts));
}

std::vector<Configuration::Mounted*> Configuration::keptTogether(const std::string& mount) {
  const auto group = std::find_if(together_.begin(), together_.end(), [&](const auto& mounts) {
    return std::find(mounts.begin(), mounts.end(), mount) != mounts.end();
  });
  if (group == together_.end()) {
    return {&mounted(mount)};
  }
  std::vector<Mounted*> entries;
  for (const std::string& member : *group) {
    if (mounts_.contains(member)) {
      entries.push_back(&mounted(member));
    }
  }
  return entries;
}

void Configuration::save() {
  const std::lock_guard lock{mutex_};
  std::set<std::vector<Mounted*>> groups;
  for (const auto& [name, entry] : mounts_) {
    if (!entry->changed.empty()) {
      groups.insert(keptTogether(name));
    }
  }
  save(groups);
}

void Configuration::save(const std::string& mount) {
  const std::lock_guard lock{mutex_};
  save(std::set{keptTogether(mount)});
}

bool Configuration::isSaved(std::string_view mount) const {
  const std::lock_guard lock{mutex_};
  return mounted(mount).changed.empty();
}

void Configuration::writeTo(const std::filesystem::path& root) const {
  std::map<std::filesystem::path, json> changed; // content after a save
  {
    const std::lock_guard lock{mutex_};
    for (const auto& [name, entry] : mounts_) {
      if (!entry->changed.empty()) {
        changed[target(*entry).lexically_relative(folders_.saved)] = toSave(*entry);
      }
    }
  }
  std::set<std::filesystem::path> files = filesIn(folders_.shipped), saved = filesIn(folders_.saved);
  std::erase_if(saved, [](const std::filesystem::path& file) { // beside layers, a robot's folder holds its history
    return *file.begin() != "location";
  });
  files.insert(saved.begin(), saved.end());
  for (const auto& [file, content] : changed) {
    files.insert(file);
  }
  for (const auto& file : files) {
    std::filesystem::create_directories((root / file).parent_path());
    const bool isWhole = !changed.contains(file) && !(folders_.areTwo() && saved.contains(file));
    writer_(root / file, isWhole ? textOf(folders_.shipped / file) : text(merged(file, changed)));
  }
}

json Configuration::merged(const std::filesystem::path& file,
                           const std::map<std::filesystem::path, json>& changed) const {
  json content = readConfiguration(folders_.shipped / file).value_or(json::object());
  const auto found = changed.find(file);
  content.update(found != changed.end() ? found->second
                                        : readConfiguration(folders_.saved / file).value_or(json::object()));
  return content;
}

void Configuration::undo(const std::string& mount) {
  const std::lock_guard lock{mutex_};
  const std::vector<Mounted*> entries = keptTogether(mount);
  std::vector<FileContent> files;
  for (const Mounted* entry : entries) {
    const auto file = target(*entry);
    if (!readConfiguration(previousOf(file))) {
      throw ConfigurationError{fmt::format("{}: nothing was saved that could be undone", entry->name)};
    }
    files.push_back({file, textOf(previousOf(file))});
  }
  writeFilesAtomically(journal(), folders_.saved, files, writer_);
  for (Mounted* entry : entries) {
    std::filesystem::remove(previousOf(target(*entry)));
    Overlay overlay{layerFiles(folders_, entry->file, entry->part, names_)};
    if (entry->listener) {
      for (const auto& [key, value] : overlay.merged->items()) {
        entry->listener(key, value);
      }
    }
    entry->overlay = std::move(overlay);
    entry->changed.clear();
  }
}

} // namespace naocal

#include "framework/Configuration.hpp"

#include "framework/Errors.hpp"
#include "framework/JsonPath.hpp"
#include "framework/Mounted.hpp"

#include <fmt/format.h>

namespace naocal {

using nlohmann::json;

Configuration::Configuration(ConfigurationFolders folders, RobotNames names, FileWriter writer,
                             const std::function<void(std::string_view)>& log)
    : folders_{std::move(folders)}, names_{std::move(names)}, writer_{std::move(writer)} {
  if (const std::string refused = finishWriting(journal(), folders_.saved, writer_); !refused.empty()) {
    log(refused);
  }
}
Configuration::~Configuration() = default;

void Configuration::mount(const std::string& mount, const std::string& file, Part part, Listener listener,
                          std::set<std::string> unsaved) {
  Overlay overlay{layersOf(folders_, file, part, names_)};
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

void Configuration::keys(std::string_view mount, json& out) const {
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
  const auto place = placeAt(changed, path);
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

} // namespace naocal

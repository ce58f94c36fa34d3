#include "framework/Configuration.hpp"

#include "framework/Errors.hpp"
#include "framework/JsonPath.hpp"

#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace naocal {

using nlohmann::json;

struct Configuration::Mounted {
  std::string name;
  std::string file;
  Part part = Part::none;
  Listener listener;
  Overlay overlay;
  json published = json::object();
  std::set<std::string> changed; // top-level keys since the last save
};

namespace {

std::filesystem::path previousOf(const std::filesystem::path& file) {
  return file.string() + ".previous";
}

std::string written(const json& object) {
  return object.dump(2) + "\n";
}

/// A file's bytes with all comments; an empty object's for one that does not exist.
std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  std::ostringstream text;
  text << stream.rdbuf();
  return stream ? text.str() : "{}\n";
}

} // namespace

Configuration::Configuration(std::filesystem::path root, RobotNames names, Writer writer)
    : root_{std::move(root)}, names_{std::move(names)}, writer_{std::move(writer)} {}
Configuration::~Configuration() = default;

void Configuration::mount(const std::string& mount, const std::string& file, Part part, Listener listener) {
  Overlay overlay{layersOf(root_, file, part, names_)};
  const std::lock_guard lock{mutex_};
  const auto [place, isNew] = mounts_.try_emplace(mount);
  if (!isNew) {
    throw ConfigurationError{fmt::format("{} is mounted twice; give one of the two modules another name", mount)};
  }
  place->second.reset(new Mounted{mount, file, part, std::move(listener), std::move(overlay)});
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
  *entry.overlay.merged = std::move(changed);
  entry.changed.insert(place.topLevelKey);
}

std::filesystem::path Configuration::target(const Mounted& entry) const {
  const auto layers = layersOf(root_, entry.file, entry.part, names_);
  const std::size_t perLocation = entry.part == Part::none ? 1 : 3;
  for (std::size_t i = perLocation; i < layers.size(); ++i) {
    for (const auto& [key, origin] : entry.overlay.origins) {
      if (origin == layers[i]) {
        return layers.back();
      }
    }
  }
  return layers[perLocation - 1];
}

std::filesystem::path Configuration::savedFile(std::string_view mount) const {
  const std::lock_guard lock{mutex_};
  return target(mounted(mount));
}

void Configuration::save(Mounted& entry) {
  const auto file = target(entry);
  json content = readConfiguration(file).value_or(json::object());
  for (const std::string& key : entry.changed) {
    content[key] = (*entry.overlay.merged)[key];
  }
  std::filesystem::create_directories(file.parent_path());
  writer_(previousOf(file), textOf(file));
  writer_(file, written(content));
  for (const std::string& key : entry.changed) {
    entry.overlay.origins[key] = file;
  }
  entry.overlay.last = file;
  entry.changed.clear();
}

void Configuration::save() {
  const std::lock_guard lock{mutex_};
  for (const auto& [name, entry] : mounts_) {
    if (!entry->changed.empty()) {
      save(*entry);
    }
  }
}

void Configuration::undo(std::string_view mount) {
  const std::lock_guard lock{mutex_};
  Mounted& entry = mounted(mount);
  const auto file = target(entry);
  if (!readConfiguration(previousOf(file))) {
    throw ConfigurationError{fmt::format("{}: nothing was saved that could be undone", mount)};
  }
  const std::string previous = textOf(previousOf(file));
  const std::string present = textOf(file);
  writer_(file, previous);
  writer_(previousOf(file), present);
  Overlay overlay{layersOf(root_, entry.file, entry.part, names_)};
  if (entry.listener) {
    for (const auto& [key, value] : overlay.merged->items()) {
      entry.listener(key, value);
    }
  }
  entry.overlay = std::move(overlay);
  entry.changed.clear();
}

} // namespace naocal

#include "ListedMounts.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

void ListedMounts::want(const std::string& mount) {
  listed_.contains(mount) ? ask_(mount) : void(wanted_.insert(mount));
}

void ListedMounts::listed(const nlohmann::json& told) {
  listed_.clear();
  for (const nlohmann::json& mount : told.at("keys")) {
    listed_.insert(mount.at("key").get<std::string>());
  }
  for (const std::string& mount : std::exchange(wanted_, {})) {
    want(mount);
  }
}

void ListedMounts::forget() {
  listed_.clear();
  wanted_.clear();
}

} // namespace naocal

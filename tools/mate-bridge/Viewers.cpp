#include "Viewers.hpp"

namespace naocal {

void Viewers::add(const std::string& key, std::size_t viewer) {
  viewers_[key].insert(viewer);
}

bool Viewers::remove(const std::string& key, std::size_t viewer) {
  const auto found = viewers_.find(key);
  if (found == viewers_.end() || found->second.erase(viewer) == 0 || !found->second.empty()) {
    return false;
  }
  viewers_.erase(found);
  return true;
}

std::vector<std::string> Viewers::forget(std::size_t viewer) {
  std::vector<std::string> keys, unseen;
  for (const auto& [key, viewers] : viewers_) {
    keys.push_back(key);
  }
  for (const std::string& key : keys) {
    if (remove(key, viewer)) {
      unseen.push_back(key);
    }
  }
  return unseen;
}

const std::set<std::size_t>& Viewers::of(std::string_view key) const {
  static const std::set<std::size_t> none;
  const auto found = viewers_.find(key);
  return found == viewers_.end() ? none : found->second;
}

} // namespace naocal

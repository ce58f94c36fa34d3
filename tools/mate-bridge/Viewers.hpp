#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Who looks at which of a robot's keys.
class Viewers {
public:
  void add(const std::string& key, std::size_t viewer);
  /// Whether nobody looks at that key any more.
  bool remove(const std::string& key, std::size_t viewer);
  /// The keys that nobody looks at once this one has gone.
  std::vector<std::string> forget(std::size_t viewer);

  const std::set<std::size_t>& of(std::string_view key) const;

private:
  std::map<std::string, std::set<std::size_t>, std::less<>> viewers_; // by key; none is empty
};

} // namespace naocal

#include "inspection/UnknownKeys.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// Number of insertions, deletions and replacements of characters that turn one word into the other.
std::size_t editDistance(const std::string& one, const std::string& other) {
  std::vector<std::size_t> row(other.size() + 1);
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = i;
  }
  for (std::size_t i = 1; i <= one.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t k = 1; k <= other.size(); ++k) {
      const std::size_t replaced = diagonal + (one[i - 1] == other[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string closestMissing(const std::string& key, const nlohmann::json& object, const std::set<std::string>& asked) {
  std::vector<std::string> missing;
  std::copy_if(asked.begin(), asked.end(), std::back_inserter(missing),
               [&](const std::string& known) { return !object.contains(known); });
  const auto names = closestNames(key, missing, 1);
  return !names.empty() && editDistance(key, names.front()) <= std::max<std::size_t>(1, key.size() / 3) ? names.front()
                                                                                                        : "";
}

void walk(const nlohmann::json& value, const std::string& path, const AskedKeys& asked,
          std::vector<UnknownKey>& found) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      walk(value[i], fmt::format("{}[{}]", path, i), asked, found);
    }
  }
  const auto known = asked.find(&value);
  if (!value.is_object() || known == asked.end()) {
    return;
  }
  for (const auto& [key, child] : value.items()) {
    if (known->second.contains(key)) {
      walk(child, path.empty() ? key : path + "." + key, asked, found);
    } else {
      found.push_back({path, key, closestMissing(key, value, known->second)});
    }
  }
}

} // namespace

std::vector<UnknownKey> findUnknownKeys(const nlohmann::json& document, const AskedKeys& asked) {
  std::vector<UnknownKey> found;
  walk(document, "", asked, found);
  return found;
}

} // namespace naocal

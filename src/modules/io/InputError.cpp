#include "io/InputError.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace naocal {

namespace {

/// Levenshtein distance: number of insertions, deletions and substitutions.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = std::exchange(row[j + 1], std::min({row[j] + 1, row[j + 1] + 1, replaced}));
    }
  }
  return row.back();
}

} // namespace

std::vector<std::string> closestNames(const std::string& text, const std::vector<std::string>& known,
                                      std::size_t most) {
  std::vector<std::string> result = known;
  std::stable_sort(result.begin(), result.end(),
                   [&](const std::string& a, const std::string& b) { return distance(text, a) < distance(text, b); });
  result.resize(std::min(most, result.size()));
  return result;
}

} // namespace naocal

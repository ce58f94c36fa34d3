#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <utility>

namespace naocal {

namespace {

/// Levenshtein distance: number of insertions, deletions and substitutions.
std::size_t distance(std::string_view a, std::string_view b) {
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

std::string printableText(std::string_view text, std::size_t longest) {
  std::string result;
  const std::string_view shown = text.substr(0, longest);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto byte = static_cast<unsigned char>(shown[i]);
    const auto next = i + 1 < shown.size() ? static_cast<unsigned char>(shown[i + 1]) : 0;
    if (byte == 0xc2 && next >= 0x80 && next < 0xa0) { // U+0080 to U+009F
      result += fmt::format("\\x{:02x}", next);
      ++i;
    } else if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += shown[i];
    }
  }
  return text.size() > longest ? result + "..." : result;
}

std::vector<std::string> closestNames(const std::string& text, const std::vector<std::string>& known,
                                      std::size_t most) {
  const auto start = [](const std::string& name) { return std::string_view{name}.substr(0, longestComparedName); };
  std::vector<std::pair<std::size_t, std::string>> ranked; // distance and name
  for (const std::string& name : known) {
    ranked.emplace_back(distance(start(text), start(name)), name);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  ranked.resize(std::min(most, ranked.size()));
  std::vector<std::string> result;
  for (auto& [away, name] : ranked) {
    result.push_back(std::move(name));
  }
  return result;
}

} // namespace naocal

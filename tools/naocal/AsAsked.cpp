#include "AsAsked.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

std::string AsAsked::words(const std::vector<std::string>& added) const {
  std::vector<std::string> all = with;
  all.insert(all.end(), added.begin(), added.end());
  std::string result = fmt::format("{}", fmt::join(sets, " "));
  result += all.empty() ? "" : fmt::format(" --with {}", fmt::join(all, ","));
  result += without.empty() ? "" : fmt::format(" --without {}", fmt::join(without, ","));
  result += model.empty() ? "" : fmt::format(" --model {}", model);
  result += samePlace ? " --same-place" : "";
  return result + (skipBad ? " --skip-bad" : "");
}

} // namespace naocal

#include "evaluation/Proportion.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

Proportion proportion(std::size_t successes, std::size_t trials) {
  if (trials == 0) {
    return {};
  }
  constexpr double z = 1.959964;
  const auto count = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / count, scale = 1 + z * z / count;
  const double centre = (share + z * z / (2 * count)) / scale;
  const double half = z * std::sqrt(share * (1 - share) / count + z * z / (4 * count * count)) / scale;
  return {share, std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

} // namespace naocal

#include "brain/PictureDifference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace naocal {

double pictureDifference(const GreyPicture& one, const GreyPicture& other) {
  constexpr int block = 16;
  constexpr double share = 0.95;
  if (one.width != other.width || one.height != other.height || one.width < block || one.height < block) {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<double> all;
  for (int top = 0; top + block <= one.height; top += block) {
    std::vector<double> row;
    for (int left = 0; left + block <= one.width; left += block) {
      int sum = 0;
      for (int v = top; v < top + block; ++v) {
        const std::size_t first = std::size_t(v) * std::size_t(one.width) + std::size_t(left);
        for (std::size_t i = first; i < first + block; ++i) {
          sum += one.pixels[i] - other.pixels[i];
        }
      }
      row.push_back(double(sum) / (block * block));
    }
    std::vector<double> sorted = row;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    for (const double difference : row) {
      all.push_back(std::abs(difference - *middle));
    }
  }
  const auto most = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), most, all.end());
  return *most;
}

} // namespace naocal

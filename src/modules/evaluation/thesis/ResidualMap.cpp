#include "evaluation/thesis/ResidualMap.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace naocal {

void ResidualMap::add(const Square& square) {
  constexpr int side = 2 * reach + 1;
  if (std::abs(square.x) > reach || std::abs(square.y) > reach) {
    return;
  }
  squares_.resize(side * side);
  Square& sum = squares_[static_cast<std::size_t>((square.x + reach) * side + square.y + reach)];
  sum = {square.x, square.y, sum.count + square.count, sum.sum + square.sum};
}

void ResidualMap::add(const Eigen::Vector2d& point, double residual) {
  const Eigen::Vector2d square = (point / width).array().round();
  if (square.cwiseAbs().maxCoeff() <= reach) {
    add({static_cast<int>(square.x()), static_cast<int>(square.y()), 1, residual});
  }
}

void ResidualMap::add(const ResidualMap& other) {
  for (const Square& square : other.squares()) {
    add(square);
  }
}

std::vector<ResidualMap::Square> ResidualMap::squares() const {
  std::vector<Square> result;
  std::copy_if(squares_.begin(), squares_.end(), std::back_inserter(result),
               [](const Square& square) { return square.count > 0; });
  return result;
}

} // namespace naocal

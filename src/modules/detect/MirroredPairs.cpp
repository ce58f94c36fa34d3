#include "detect/MirroredPairs.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {
namespace {

constexpr double narrowest = 2.0, widest = 7.0; // half the window [px]
constexpr double spacing = 0.7;                 // of the places [px]

/// Half the window in one direction of the board.
struct Half {
  double squares = 0;
  int places = 0; // on either side of the corner
};

Half half(double pixelsPerSquare, double reach) {
  const double pixels = std::clamp(reach * pixelsPerSquare, narrowest, widest);
  return {pixels / pixelsPerSquare, int(std::ceil(pixels / spacing))};
}

} // namespace

std::vector<MirroredPair> mirroredPairs(const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& pixelFromBoard,
                                        const Eigen::Vector2d& corner, double reach, bool risingIsWhite) {
  const Eigen::Vector2d centre = pixelFromBoard(corner);
  const auto pixelsPerSquare = [&](const Eigen::Vector2d& direction) {
    return (pixelFromBoard(corner + 0.1 * direction) - pixelFromBoard(corner - 0.1 * direction)).norm() / 0.2;
  };
  const Half x = half(pixelsPerSquare(Eigen::Vector2d::UnitX()), reach);
  const Half y = half(pixelsPerSquare(Eigen::Vector2d::UnitY()), reach);
  std::vector<MirroredPair> pairs;
  for (int row = 0; row < y.places; ++row) {
    for (int column = -x.places; column < x.places; ++column) {
      const double shareX = (column + 0.5) / x.places, shareY = (row + 0.5) / y.places;
      const Eigen::Vector2d offset{shareX * x.squares, shareY * y.squares};
      pairs.push_back({pixelFromBoard(corner + offset) - centre, pixelFromBoard(corner - offset) - centre,
                       (1 - shareX * shareX) * (1 - shareY * shareY), (column >= 0) == risingIsWhite});
    }
  }
  return pairs;
}

} // namespace naocal

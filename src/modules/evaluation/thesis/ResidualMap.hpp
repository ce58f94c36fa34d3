#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// Mean residuals of floor points after many calibrations, in squares of 5 cm around the sole, as far as 3 m.
class ResidualMap {
public:
  static constexpr double width = 0.05; // of a square [m]
  static constexpr int reach = 60;      // squares in each direction from the one under the sole's origin

  /// A square: its indices along x and y, 0 at the origin, and its residuals.
  struct Square {
    int x = 0, y = 0;
    std::size_t count = 0;
    double sum = 0; // of the residuals' lengths [px]
  };

  /// Points beyond the map are ignored.
  void add(const Eigen::Vector2d& point, double residual);
  void add(const Square& square);
  void add(const ResidualMap& other);

  /// All squares with residuals, by x, then y.
  std::vector<Square> squares() const;

private:
  std::vector<Square> squares_; // empty, or all by x, then y
};

} // namespace naocal

#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace naocal {

/// How a range is sampled: at random, evenly at any count (Sobol's low-discrepancy sequence), or on a grid.
enum class Sampling { random, even, grid };

/// A sequence of points in the unit cube.
class UnitPoints {
public:
  virtual ~UnitPoints() = default;

  /// The next point, one number in [0, 1) per dimension.
  virtual void next(std::span<double> point) = 0;
};

/// Points `first`, `first + 1`, ... of a sequence of `count` points in `dimensions`; those of a grid lie in the middle
/// of its cells, of which there are as many as `count` allows, at least one along every dimension.
std::unique_ptr<UnitPoints> unitPoints(Sampling sampling, std::uint64_t seed, std::size_t dimensions, std::size_t count,
                                       std::size_t first);

} // namespace naocal

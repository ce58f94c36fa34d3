#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <string_view>

namespace naocal {

/// Sampling of a range: random, low-discrepancy (Sobol sequence, even at any count), or on a grid.
enum class SamplingMethod { random, even, grid };

/// A sequence of points in the unit cube.
class UnitCubeSampler {
public:
  virtual ~UnitCubeSampler() = default;

  /// The next point, one number in [0, 1) per dimension.
  virtual void next(std::span<double> point) = 0;
};

/// Points `first`, `first + 1`, ... of a sequence of `count` points in `dimensions`. A grid uses cell centres, with as
/// many cells as `count` allows, at least one per dimension.
std::unique_ptr<UnitCubeSampler> makeSampler(SamplingMethod sampling, std::uint64_t seed, std::size_t dimensions,
                                             std::size_t count, std::size_t first);

/// A random stream, reproducible by seed and named by purpose, so that drawing more of one kind (pixel noise) does not
/// change others (robot, motions).
class RandomStream {
public:
  RandomStream(std::uint64_t seed, std::string_view purpose) {
    std::seed_seq sequence{seed & 0xffffffffU, seed >> 32, hash(purpose) & 0xffffffffU, hash(purpose) >> 32};
    engine_.seed(sequence);
  }

  /// Uniform in [-range, range].
  double uniformWithin(double range) { return range * (2 * unit_(engine_) - 1); }
  bool bernoulli(double probability) { return unit_(engine_) < probability; }
  /// Normal with mean 0.
  double normal(double sigma) { return sigma * normal_(engine_); }
  /// Student's t with 4 degrees of freedom, scaled to the standard deviation `sigma` (its own is sqrt 2).
  double studentT4(double sigma) { return sigma / std::numbers::sqrt2 * student_(engine_); }
  /// Uniform on the circle of radius `length`.
  Eigen::Vector2d randomDirection(double length) {
    const double angle = uniformWithin(std::numbers::pi);
    return {length * std::cos(angle), length * std::sin(angle)};
  }
  /// Uniform integer in [0, count).
  std::size_t uniformBelow(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>{0, count - 1}(engine_);
  }

private:
  static std::uint64_t hash(std::string_view text) { // FNV-1a: identical on every machine
    std::uint64_t result = 0xcbf29ce484222325;
    for (const char character : text) {
      result = (result ^ static_cast<unsigned char>(character)) * 0x100000001b3;
    }
    return result;
  }

  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> unit_{0, 1};
  std::normal_distribution<double> normal_{0, 1};
  std::student_t_distribution<double> student_{4};
};

} // namespace naocal

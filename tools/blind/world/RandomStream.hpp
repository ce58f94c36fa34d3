#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace blind {

/// Reproducible random numbers from a seed and a word, equal on every machine: xoshiro256** (Blackman and Vigna 2018),
/// seeded by SplitMix64.
class RandomStream {
public:
  RandomStream(std::uint64_t seed, std::string_view purpose);

  std::uint64_t next(); // 64 random bits
  double uniform();     // [0, 1)
  double between(double low, double high) { return low + (high - low) * uniform(); }
  double uniformWithin(double range) { return between(-range, range); }
  double sign() { return uniform() < 0.5 ? -1 : 1; }
  int below(int count) { return static_cast<int>(uniform() * count); }
  double normal(double sigma);         // Marsaglia's polar method
  double studentFour(double sigma);    // Student's t with 4 degrees of freedom, scaled to this standard deviation
  double uniformOfSigma(double sigma); // uniform, with this standard deviation

private:
  std::array<std::uint64_t, 4> state_{};
};

} // namespace blind

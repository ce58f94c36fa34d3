#include "math/Sampling.hpp"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <random>
#include <vector>

namespace naocal {

namespace {

class RandomPoints : public UnitCubeSampler {
public:
  RandomPoints(std::uint64_t seed, std::size_t first) {
    std::seed_seq mixed{seed, static_cast<std::uint64_t>(first)};
    random_.seed(mixed);
  }
  void next(std::span<double> point) override {
    std::generate(point.begin(), point.end(), [&] { return std::uniform_real_distribution{0.0, 1.0}(random_); });
  }

private:
  std::mt19937_64 random_;
};

/// Sobol sequence with a random shift modulo 1, determined by the seed.
class SobolPoints : public UnitCubeSampler {
public:
  SobolPoints(std::uint64_t seed, std::size_t dimensions, std::size_t first) : sobol_{dimensions}, shift_(dimensions) {
    RandomPoints{seed, 0}.next(shift_);
    sobol_.discard(first * dimensions);
  }
  void next(std::span<double> point) override {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double shifted = static_cast<double>(sobol_()) * 0x1p-64 + shift_[i];
      point[i] = shifted < 1 ? shifted : shifted - 1;
    }
  }

private:
  boost::random::sobol sobol_;
  std::vector<double> shift_;
};

class GridPoints : public UnitCubeSampler {
public:
  GridPoints(std::size_t dimensions, std::size_t count, std::size_t first) : cells_(dimensions, 1), index_{first} {
    for (std::size_t product = 1, i = 0;; i = (i + 1) % dimensions) { // adds a cell along each dimension in turn
      product = product / cells_[i] * (cells_[i] + 1);
      if (product > count) {
        break;
      }
      ++cells_[i];
    }
  }
  void next(std::span<double> point) override {
    std::size_t rest = index_++;
    for (std::size_t i = 0; i < point.size(); ++i) {
      point[i] = (static_cast<double>(rest % cells_[i]) + 0.5) / static_cast<double>(cells_[i]);
      rest /= cells_[i];
    }
  }

private:
  std::vector<std::size_t> cells_;
  std::size_t index_;
};

} // namespace

std::unique_ptr<UnitCubeSampler> makeSampler(SamplingMethod sampling, std::uint64_t seed, std::size_t dimensions,
                                             std::size_t count, std::size_t first) {
  switch (sampling) {
  case SamplingMethod::random:
    return std::make_unique<RandomPoints>(seed, first);
  case SamplingMethod::even:
    return std::make_unique<SobolPoints>(seed, dimensions, first);
  case SamplingMethod::grid:
    break;
  }
  return std::make_unique<GridPoints>(dimensions, count, first);
}

} // namespace naocal

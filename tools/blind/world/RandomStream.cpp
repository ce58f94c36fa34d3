#include "world/RandomStream.hpp"

#include <bit>
#include <cmath>

namespace blind {

RandomStream::RandomStream(std::uint64_t seed, std::string_view purpose) {
  std::uint64_t mixed = seed * 0x9e3779b97f4a7c15u + 0x632be59bd9b4e019u;
  for (const char letter : purpose) {
    mixed = (mixed ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
  }
  for (std::uint64_t& word : state_) { // SplitMix64
    mixed += 0x9e3779b97f4a7c15u;
    word = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
    word ^= word >> 31;
  }
}

std::uint64_t RandomStream::next() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double RandomStream::uniform() {
  return static_cast<double>(next() >> 11) * 0x1.0p-53;
}

double RandomStream::normal(double sigma) {
  double x = 0, y = 0, square = 0;
  do {
    x = uniformWithin(1);
    y = uniformWithin(1);
    square = x * x + y * y;
  } while (square >= 1 || square == 0);
  return sigma * x * std::sqrt(-2 * std::log(square) / square);
}

double RandomStream::studentFour(double sigma) {
  double square = 0;
  for (int i = 0; i < 4; ++i) {
    const double draw = normal(1);
    square += draw * draw;
  }
  return sigma / std::sqrt(2.0) * normal(1) / std::sqrt(square / 4); // t4's variance is 2
}

double RandomStream::uniformOfSigma(double sigma) {
  return uniformWithin(std::sqrt(3.0) * sigma);
}

} // namespace blind

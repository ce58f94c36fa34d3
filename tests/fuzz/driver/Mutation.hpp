#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace naocal {

inline constexpr std::size_t largestInput = 200'000; // [bytes]

/// One to four random changes of one of the inputs: flipped bits, other digits, truncation, removed and repeated
/// stretches, spliced halves of two inputs, and words that often break readers. At most `largestInput` bytes. The same
/// generator state gives the same result. `inputs` must not be empty.
std::string mutate(const std::vector<std::string>& inputs, std::mt19937_64& random);

} // namespace naocal

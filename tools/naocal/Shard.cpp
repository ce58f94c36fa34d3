#include "Shard.hpp"

#include "io/InputError.hpp"

#include <cstdio>
#include <fmt/format.h>

namespace naocal {

Shard readShard(const std::string& text) {
  Shard shard;
  if (std::sscanf(text.c_str(), "%zu/%zu", &shard.part, &shard.parts) != 2 || shard.part >= shard.parts) {
    throw InputError{fmt::format("--shard: expected i/n with i from 0 to n - 1, found \"{}\"", text)};
  }
  return shard;
}

} // namespace naocal

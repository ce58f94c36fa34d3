#pragma once

#include <cstddef>
#include <string>

namespace naocal {

/// A part of a long evaluation: of its pieces those numbered part, part + parts, part + 2 parts, ...
struct Shard {
  std::size_t part = 0, parts = 1;
};

/// Reads "2/8", the third of eight parts. Throws InputError for anything else.
Shard readShard(const std::string& text);

} // namespace naocal

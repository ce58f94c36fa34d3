#pragma once

#include <malloc.h>

namespace naocal {

/// For the beginning of a program that fits models: matrices come and go by the megabyte, and their memory is kept
/// instead of given back to the system and asked for again, which would take as long as the arithmetic and would be
/// waited for by all threads.
inline void keepMemory() {
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

} // namespace naocal

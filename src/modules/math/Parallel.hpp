#pragma once

#include <algorithm>
#include <cstddef>
#include <malloc.h>
#include <tbb/parallel_for.h>
#include <vector>

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#include <atomic>
#include <thread>
#define NAOCAL_OWN_THREADS
#endif
#endif

namespace naocal {

/// body(i) for i = 0 .. count - 1 on all cores, in any order; returns when all are done. May be called by a body. What
/// a body throws is thrown here.
///
/// Under the thread sanitizer by two threads of its own, which must not throw: it cannot see how a library's threads
/// take turns, so that it would either accuse every body or have to overlook whatever they do.
template <class Body> void parallelFor(std::size_t count, const Body& body) {
#ifdef NAOCAL_OWN_THREADS
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      body(i);
    }
  };
  std::jthread other{work};
  work();
#else
  tbb::parallel_for(std::size_t{0}, count, body);
#endif
}

/// What body(i, part) gathers over i = 0 .. count - 1, in a few parts side by side, each of which `make` has begun. How
/// many there are does not depend on the machine: summed in their order they are the same everywhere, to the last bit.
template <class Make, class Body> auto gatherInParts(std::size_t count, const Make& make, const Body& body) {
  constexpr std::size_t most = 4;
  const std::size_t parts = std::max<std::size_t>(1, std::min(most, count));
  std::vector<decltype(make())> result;
  for (std::size_t part = 0; part < parts; ++part) {
    result.push_back(make());
  }
  parallelFor(parts, [&](std::size_t part) {
    for (std::size_t i = part * count / parts; i < (part + 1) * count / parts; ++i) {
      body(i, result[part]);
    }
  });
  return result;
}

/// For the beginning of a program that fits models: matrices come and go by the megabyte, and their memory is kept
/// instead of given back to the system and asked for again, which would take as long as the arithmetic and would be
/// waited for by all threads.
inline void tuneAllocator() {
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

} // namespace naocal

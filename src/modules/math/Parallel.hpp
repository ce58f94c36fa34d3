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

/// Runs body(i) for i = 0 .. count - 1 on all cores, in any order, and returns when all are done. Calls may be nested.
/// Propagates exceptions of `body`.
///
/// Under the thread sanitizer uses two threads of its own, in which `body` must not throw: the sanitizer cannot see the
/// synchronisation inside the TBB library and would report false races.
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

/// Gathers body(i, part) over i = 0 .. count - 1 in up to four parallel parts, each initialised by `make`. The number
/// of parts does not depend on the machine, so sums over them in order are bitwise reproducible.
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

/// Tunes malloc for programs that fit models; call at start. Keeps freed memory of matrices (megabytes each) instead of
/// returning it to the system, which would take as long as the arithmetic and block all threads.
inline void tuneAllocator() {
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

} // namespace naocal

#pragma once

namespace naocal {

/// Four numbers at once: the inner loops treat corners in fours, which every processor since SSE2 does in parallel.
/// Arithmetic and comparison work on all four, [i] on one of them. (A member, never a template's argument: that would
/// lose its alignment.)
using Double4 [[gnu::vector_size(4 * sizeof(double)), gnu::aligned(4 * sizeof(double))]] = double;

inline double sum(const Double4& lane) {
  return (lane[0] + lane[1]) + (lane[2] + lane[3]);
}

#ifdef __x86_64__
template <typename Work> [[gnu::target("avx2,fma")]] void runWithAvx2(const Work& work) {
  work();
}
#endif

/// Calls `work`, of whose code there are two: for any processor, and for those with AVX2 and fused multiply-add. `work`
/// must be an always_inline lambda. The two differ in rounding only.
template <typename Work> void dispatchSimd(const Work& work) {
#ifdef __x86_64__
  static const bool wide = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (wide) {
    return runWithAvx2(work);
  }
#endif
  work();
}

} // namespace naocal

#pragma once

namespace naocal {

/// Four doubles at once (SIMD): inner loops process corners in blocks of four, in parallel on any processor since SSE2.
/// Arithmetic and comparison work element-wise, [i] selects one. (Use as a member, not as a template argument, which
/// would lose its alignment.)
using Double4 [[gnu::vector_size(4 * sizeof(double)), gnu::aligned(4 * sizeof(double))]] = double;

inline double sum(const Double4& lane) {
  return (lane[0] + lane[1]) + (lane[2] + lane[3]);
}

#ifdef __x86_64__
template <typename Work> [[gnu::target("avx2,fma")]] void runWithAvx2(const Work& work) {
  work();
}
#endif

/// Runs `work`, compiled twice: for any processor, and for AVX2 with fused multiply-add. `work` must be an
/// always_inline lambda. The two versions differ only in rounding.
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

#pragma once

// Loops over four numbers at once, with AVX2 where the processor has it. Multiplications and
// additions stay separate, so the bits are the same on every processor.

#if defined(__x86_64__)
#include <sys/platform/x86.h>
#endif

namespace traj {

// Four doubles in a row, anywhere in memory: four(&array[i]) += 2 * four(&array[j]).
using Four [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

#define SKYWAY_FOUR_LANES __attribute__((always_inline))

SKYWAY_FOUR_LANES inline Four& four(double* at) { return *reinterpret_cast<Four*>(at); }
SKYWAY_FOUR_LANES inline const Four& four(const double* at) {
  return *reinterpret_cast<const Four*>(at);
}

#if defined(__x86_64__)
template <class F>
[[gnu::target("avx2")]] auto on_avx2(const F& f) {
  return f();
}
#endif

// What f() returns. f is a lambda with SKYWAY_FOUR_LANES, as is all that it calls in its loops.
template <class F>
auto with_four_lanes(const F& f) {
#if defined(__x86_64__)
  static const bool usable = CPU_FEATURE_ACTIVE(AVX2);
  if (usable) return on_avx2(f);
#endif
  return f();
}

}  // namespace traj

// Compiled for whatever the build is for: SSE2 in `release`, all of this processor in `native`.
#include "many_balls/pass_kernel.hpp"

namespace bounce::many {

double pass_scalar(const Pass& pass, Slot first, Slot last) {
  return move_all<double>(pass, first, last);
}

double pass_vector(const Pass& pass, Slot first, Slot last) {
  return move_all<Lanes>(pass, first, last);
}

PassFunction fastest_pass() {
#if BOUNCE_WIDER_PASSES
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) return pass_avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return pass_avx2;
#endif
  return pass_vector;
}

}  // namespace bounce::many

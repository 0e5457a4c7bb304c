// Compiled for AVX-512, and called on processors that have it: eight balls side by side.
#include "many_balls/pass_kernel.hpp"

namespace bounce::many {

double pass_avx512(const Pass& pass, Slot first, Slot last) {
  return move_all<Lanes>(pass, first, last);
}

}  // namespace bounce::many

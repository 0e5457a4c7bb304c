#pragma once
// Random numbers that are the same on every machine. The generators of <random> give the same bits
// everywhere: the standard says which. Its distributions and std::shuffle do not: each library
// computes its own numbers of those bits.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace bounce::test {

/// From low to high, by 64 bits of the generator: the numbers of libstdc++'s
/// std::uniform_real_distribution.
template <class Generator>
double uniform(Generator& generator, double low, double high) {
  constexpr bool half = Generator::max() == 0xffffffff;  // std::mt19937: 32 bits at a time
  static_assert(Generator::min() == 0 && (half || Generator::max() == 0xffffffffffffffff));
  std::uint64_t bits = generator();
  if (half) bits |= std::uint64_t{generator()} << 32;
  const double share = std::min(static_cast<double>(bits) * 0x1p-64, 1 - 0x1p-53);
  return share * (high - low) + low;
}

/// Normally distributed numbers with mean 0 and deviation 1, two at a time: Marsaglia's polar
/// method. Take a point anywhere in the unit disc; its direction and the square of its radius are
/// independent.
class Normal {
 public:
  template <class Generator>
  double operator()(Generator& generator) {
    if (std::exchange(has_second_, false)) return second_;
    double x = 0, y = 0, square = 0;
    do {
      x = uniform(generator, -1, 1);
      y = uniform(generator, -1, 1);
      square = x * x + y * y;
    } while (square > 1 || square == 0);
    const double size = std::sqrt(-2 * std::log(square) / square);
    second_ = x * size;
    has_second_ = true;
    return y * size;
  }

 private:
  double second_ = 0;
  bool has_second_ = false;
};

/// Any order of the numbers from `first` to `last`.
template <class Iterator, class Generator>
void shuffle(Iterator first, Iterator last, Generator& generator) {
  for (auto left = last - first; left > 1; --left) {
    const auto which = generator() % static_cast<std::uint64_t>(left);
    std::iter_swap(first + left - 1, first + static_cast<std::ptrdiff_t>(which));
  }
}

}  // namespace bounce::test

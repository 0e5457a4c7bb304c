#pragma once
#include <cmath>
#include <cstddef>

namespace bounce {

// One number, as the only one of a row.
inline double lane(double a, std::size_t) { return a; }
inline bool lane(bool answer, std::size_t) { return answer; }
inline void set_lane(double& a, std::size_t, double value) { a = value; }

// Four numbers side by side, for quick bounces of four balls at a time: two vectors of two, which
// every processor of this kind has. There is no other arithmetic than that of four numbers one by
// one, so the bits are theirs. Where the compiler knows no vectors, balls go one by one.
#if defined(__GNUC__) && !defined(__EMSCRIPTEN__)

using Pair [[gnu::vector_size(16)]] = double;
using PairAnswer = decltype(Pair{} < Pair{});

struct LanesAnswer {
  PairAnswer low, high;
  friend LanesAnswer operator&&(LanesAnswer a, LanesAnswer b) {
    return {a.low & b.low, a.high & b.high};
  }
  friend LanesAnswer operator||(LanesAnswer a, LanesAnswer b) {
    return {a.low | b.low, a.high | b.high};
  }
};

struct Lanes {
  Pair low{}, high{};
  Lanes() = default;
  Lanes(double all) : low{all, all}, high{all, all} {}
  Lanes(Pair low_, Pair high_) : low(low_), high(high_) {}

  friend Lanes operator+(Lanes a, Lanes b) { return {a.low + b.low, a.high + b.high}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.low - b.low, a.high - b.high}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.low * b.low, a.high * b.high}; }
  friend Lanes operator/(Lanes a, Lanes b) { return {a.low / b.low, a.high / b.high}; }
  Lanes operator-() const { return {-low, -high}; }
  friend LanesAnswer operator<(Lanes a, Lanes b) { return {a.low < b.low, a.high < b.high}; }
  friend LanesAnswer operator>(Lanes a, Lanes b) { return b < a; }
  friend LanesAnswer operator==(Lanes a, Lanes b) { return {a.low == b.low, a.high == b.high}; }
};

inline Lanes select(LanesAnswer condition, Lanes a, Lanes b) {
  return {condition.low ? a.low : b.low, condition.high ? a.high : b.high};
}
inline bool all(LanesAnswer answer) {
  const PairAnswer both = answer.low & answer.high;
  return (both[0] & both[1]) != 0;
}
inline Lanes square_root(Lanes a) {
  return {Pair{std::sqrt(a.low[0]), std::sqrt(a.low[1])},
          Pair{std::sqrt(a.high[0]), std::sqrt(a.high[1])}};
}

inline constexpr std::size_t lanes = 4;
inline double lane(const Lanes& a, std::size_t n) { return (n < 2 ? a.low : a.high)[n % 2]; }
inline bool lane(const LanesAnswer& a, std::size_t n) {
  return (n < 2 ? a.low : a.high)[n % 2] != 0;
}
// Not (n < 2 ? a.low : a.high)[n % 2] = value: g++ 15 and 16 write that into a copy.
inline void set_lane(Lanes& a, std::size_t n, double value) {
  if (n < 2) {
    a.low[n] = value;
  } else {
    a.high[n - 2] = value;
  }
}
#else
using Lanes = double;
inline constexpr std::size_t lanes = 1;
#endif

}  // namespace bounce

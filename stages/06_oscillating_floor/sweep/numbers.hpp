#pragma once
#include <cmath>
#include <numbers>

namespace bounce {

// What quick bounces are computed with, on one number or on several side by side (`V`): the same
// operations in the same order, and nothing of the C library but the square root, which IEEE 754
// rounds in one way. So every build and every width give the same bits.

/// What a comparison says: yes or no, for each of the numbers.
template <class V>
using Answer = decltype(V{} < V{});

inline double select(bool condition, double a, double b) { return condition ? a : b; }
inline bool all(bool condition) { return condition; }
inline double square_root(double a) { return std::sqrt(a); }

template <class V>
V absolute(const V& a) {
  return select(a < 0, -a, a);
}
template <class V>
V larger(const V& a, const V& b) {
  return select(a > b, a, b);
}
template <class V>
V smaller(const V& a, const V& b) {
  return select(a < b, a, b);
}
/// `a`, or the number nearest to it that is not larger than `most`.
template <class V>
V within(const V& a, const V& most) {
  return smaller(select(a > -most, a, -most), most);
}

/// The next whole number: one that has 2^52 added to it has no digits left behind the point.
template <class V>
V rounded(const V& a) {
  constexpr double large = 6755399441055744.0;  // 1.5 * 2^52
  return (a + large) - large;
}

/// A sine and its cosine, times a size.
template <class V>
struct Swing {
  V sine, cosine;
};

/// A swing, turned on by an angle.
template <class V>
Swing<V> operator*(const Swing<V>& a, const Swing<V>& by) {
  return {a.sine * by.cosine + a.cosine * by.sine, a.cosine * by.cosine - a.sine * by.sine};
}

template <class V>
V size_squared(const Swing<V>& a) {
  return a.sine * a.sine + a.cosine * a.cosine;
}
/// What undoes that turn, and the size.
template <class V>
Swing<V> inverse(const Swing<V>& a) {
  return {-a.sine / size_squared(a), a.cosine / size_squared(a)};
}

inline constexpr double eighth_turn = std::numbers::pi / 4;

/// An angle of an eighth of a turn at most, by the series. What they leave out is below rounding:
/// 0.8^17 / 17! = 6e-17.
template <class V>
Swing<V> small_turn(const V& angle) {
  const V x = angle * angle;
  V sine = 1 - x * (1.0 / 210), cosine = 1 - x * (1.0 / 240);  // the last terms first
  for (int n = 12; n >= 2; n -= 2) {
    sine = 1 - sine * (x * (1.0 / (n * (n + 1))));
    cosine = 1 - cosine * (x * (1.0 / ((n + 2) * (n + 1))));
  }
  return {angle * sine, 1 - x / 2 * cosine};
}

/// An angle of at most 3e-4 rad: its fourth power / 24 is below rounding.
inline constexpr double close = 3e-4;
template <class V>
Swing<V> tiny_turn(const V& angle) {
  const V half = angle * angle / 2;
  return {angle - angle * half / 3, 1 - half};
}

/// Any angle up to some 1e6 rad: less so many quarters of a turn.
template <class V>
Swing<V> turn(const V& angle) {
  const V quarters = rounded(angle * (2 / std::numbers::pi));
  // Half pi in two parts, the first of so few bits that its multiples are exact.
  constexpr double much = 1.57079632673412561417, rest = 6.07710050650619224932e-11;
  const Swing<V> small = small_turn((angle - quarters * much) - quarters * rest);
  // 0, 1, 2 or 3 of them.
  const V left = quarters - 4 * rounded((quarters - 1.5) / 4);
  const auto odd = absolute(left - 2) == 1.0;
  const V sine = select(odd, small.cosine, small.sine);
  const V cosine = select(odd, small.sine, small.cosine);
  return {select(left > 1.5, -sine, sine), select(absolute(left - 1.5) < 1, -cosine, cosine)};
}

/// An angle, less whole turns: from 0 to 2 pi.
template <class V>
V within_turn(const V& angle) {
  constexpr double much = 4 * 1.57079632673412561417, rest = 4 * 6.07710050650619224932e-11;
  const V turns = rounded(angle * (1 / (2 * std::numbers::pi)) - 0.5);
  return (angle - turns * much) - turns * rest;
}

/// e^x for |x| <= 1/4, by its series, of which 0.25^12 / 12! = 1e-16 is left out.
template <class V>
V small_exponential(const V& x) {
  V sum = 1 + x * (1.0 / 11);
  for (int n = 10; n >= 1; --n) sum = 1 + sum * (x * (1.0 / n));
  return sum;
}

/// The steps to a zero after which a search gives up.
inline constexpr int most_steps = 6;

/// A smooth function at one moment: its value and first four derivatives.
template <class V>
struct Derivatives {
  V value, first, second, third, fourth;

  /// From here to the zero, by a parabola and more (Householder's method of order 4): each step has
  /// four times as many right digits.
  V step_to_zero() const {
    const V newton = -value / first, bend = newton * second / first;
    return newton * (1 + bend / 2) / (1 + bend + newton * newton * third / first / 6);
  }
  /// Whether one more such step, of a function that swings with `w`, would be below rounding.
  Answer<V> is_near(const V& step, const V& w) const {
    return absolute(step * w) < close && absolute(step * second) < close * first;
  }
  V first_after(const V& t) const {
    return first + t * (second + t * (third / 2 + t * fourth / 6));
  }
};

}  // namespace bounce

#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace bounce {

/// What is known of a smooth function f of time at one moment.
struct BoundedValue {
  double value;     // f
  double slope;     // f'
  double bend;      // f''
  double max_bend;  // |f''| stays below this for the next `window` seconds,
  double max_turn;  // and |f'''| below this
  double window = std::numeric_limits<double>::infinity();  // s
};

/// -f, as sure as f.
inline BoundedValue operator-(const BoundedValue& f) {
  return {-f.value, -f.slope, -f.bend, f.max_bend, f.max_turn, f.window};
}

/// How long f is certain to stay positive [s], from a moment with value >= 0. It cannot fall
/// faster than its bounds allow:
///   f(s) >= value + slope s - max_bend s^2 / 2,                    positive up to its root;
///   f(s) >= value + s (slope + bend s / 2 - max_turn s^2 / 6),     for a start at zero, uphill.
inline double root_free_time(const BoundedValue& f) {
  double safe = f.window;
  if (f.max_bend > 0) {
    const double root = std::sqrt(f.slope * f.slope + 2 * f.max_bend * f.value);
    safe = f.slope > 0 ? (f.slope + root) / f.max_bend
                       : (f.value > 0 ? 2 * f.value / (root - f.slope) : 0);
  } else if (f.slope < 0) {
    safe = -f.value / f.slope;
  }
  if (f.slope >= 0 && f.max_turn > 0) {
    const double half = f.bend / 2;
    const double root = std::sqrt(half * half + 2 * f.max_turn * f.slope / 3);
    const double uphill = half > 0          ? (half + root) * 3 / f.max_turn
                          : root - half > 0 ? 2 * f.slope / (root - half)
                                            : 0;
    safe = std::max(safe, uphill);
  }
  return std::min(safe, f.window);
}

/// The end of a search: a zero at `t`, or none before `t`.
struct FirstZero {
  double t;  // s
  bool found;
};

/// The first moment after `t` at which f, positive until then, comes down through zero. It walks by
/// steps that are certain to be free of a root, so that none can be skipped, however close two of
/// them are. Near the zero these steps are those of Newton's method, taken from the safe side: each
/// doubles the number of right digits. After `max_steps`, and beyond `until`, it says how far it
/// came. `value_at(t)` returns a BoundedValue.
template <class Function>
FirstZero first_zero(const Function& value_at, double t, double until, int max_steps) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < max_steps && t <= until; ++i) {
    BoundedValue f = value_at(t);
    if (f.value <= 0 && (f.slope < 0 || (f.slope == 0 && f.bend < 0))) return {t, true};
    f.value = std::max(f.value, 0.0);  // below zero and rising: that is rounding at its start
    double step = root_free_time(f);
    if (step == std::numeric_limits<double>::infinity()) return {step, false};
    if (step == 0 && f.max_turn > 0) {
      // f, f' and f'' are all zero. In this time f''' cannot change f by more than rounding.
      step = 1e-5 * f.max_bend / f.max_turn;
    }
    t += step;
    if (step <= 2 * epsilon * t && f.slope < 0) return {t, true};
  }
  return {t, false};
}

}  // namespace bounce

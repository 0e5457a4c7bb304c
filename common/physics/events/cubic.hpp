#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/events/event_value.hpp"

namespace bounce {

/// The cubic with given values and slopes at 0 and at h: what a smooth function does in between,
/// as far as its ends tell (Hermite interpolation).
class Cubic {
 public:
  Cubic(const EventValue& start, const EventValue& end, double h)
      : value_(start.value), slope_(start.slope * h), h_(h) {
    const double rise = end.value - start.value, end_slope = end.slope * h;
    square_ = 3 * rise - 2 * slope_ - end_slope;
    cube_ = slope_ + end_slope - 2 * rise;
  }

  double at(double share) const {
    return value_ + share * (slope_ + share * (square_ + share * cube_));
  }

  /// Its minimum inside, if it has one there; the share of h at which it lies.
  std::optional<double> minimum() const {
    // slope + 2 square s + 3 cube s^2 = 0: the root at which the left side comes up through zero,
    // in the form that subtracts nothing.
    const double discriminant = square_ * square_ - 3 * cube_ * slope_;
    if (!(discriminant > 0)) return std::nullopt;
    const double root = std::sqrt(discriminant);
    const double above = square_ > 0 ? -slope_ : root - square_;
    const double below = square_ > 0 ? square_ + root : 3 * cube_;
    if (0 < above && above < below) return above / below;
    return std::nullopt;
  }

  /// The largest size of its second derivative in between, times h^2.
  double bend() const { return std::max(std::abs(2 * square_), std::abs(2 * square_ + 6 * cube_)); }

  /// Where it comes down through zero, for a start above and an end below [s]; roughly.
  double zero() const {
    double low = 0, high = 1;
    for (int i = 0; i < 30; ++i) {
      const double middle = (low + high) / 2;
      (at(middle) > 0 ? low : high) = middle;
    }
    return h_ * (low + high) / 2;
  }

 private:
  double value_, slope_, square_, cube_, h_;
};

/// Judged by values and slopes at both ends of a step that resolves the movement: there the cubic
/// is off by a small share of what its bend makes of a step. Where it comes closer to zero than
/// that in between, a shorter step must tell. The values are right to `rounding`: what stays within
/// that of zero has not ended, and a dip of that size is none.
inline RootInStep root_in_step(const EventValue& before, const EventValue& after, double h,
                               double rounding) {
  const Cubic cubic(before, after, h);
  if (const std::optional<double> lowest = cubic.minimum()) {
    const double low = cubic.at(*lowest);
    const bool dips = std::min(before.value, after.value) - low > rounding;
    if (dips && !(low > cubic.bend() / 64)) return RootInStep::unclear;
  }
  if (after.value >= -rounding) return RootInStep::none;
  // From zero up and down again: only a shorter step finds where it comes down.
  const bool rises = before.value <= rounding && before.slope * h > rounding;
  return rises ? RootInStep::unclear : RootInStep::one;
}

}  // namespace bounce

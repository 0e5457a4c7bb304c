#pragma once
#include <algorithm>

namespace bounce {

/// A function of time that is positive while a touch lasts, with its slope [per second].
struct EventValue {
  double value;
  double slope;
};

/// Whether a function that is positive at the start of a step comes down to zero within it.
enum class RootInStep { none, one, unclear };

/// With |f''| <= B (`max_bend`), f stays above its parabola value + slope s - B s^2 / 2, which is
/// positive between two moments at which it is; and f stays above its chord minus B dt^2 / 8.
inline bool stays_positive(const EventValue& before, const EventValue& after, double dt,
                           double max_bend) {
  if (before.value + (before.slope - max_bend * dt / 2) * dt > 0) return true;
  return std::min(before.value, after.value) > max_bend * dt * dt / 8;
}

}  // namespace bounce

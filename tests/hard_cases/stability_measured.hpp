#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "run/any_method.hpp"
#include "run/methods.hpp"

// What a method does to a contact, found by running it, without knowing its matrix.
namespace bounce::hard_cases {

/// The linear contact in units in which m = k = 1, so that omega0 = 1 and dt is omega0 dt.
struct LinearContact {
  double zeta;
  double acceleration(double /*t*/, const State<double>& state) const {
    return -state.position - 2 * zeta * state.velocity;
  }
};

/// A wall at 0, without gravity.
struct Wall {
  double zeta;
  bool only_pushes = false;
  double acceleration(double /*t*/, const State<double>& state) const {
    const double push = -state.position - 2 * zeta * state.velocity;
    return state.position < 0 ? (only_pushes ? std::max(0.0, push) : push) : 0;
  }
};

/// Calls `visit` with a fresh step of the method.
template <class Visit>
auto with_step(const Method& method, const Visit& visit) {
  AnyMethod<SteppingMethods<double>> any;
  any.begin(method);
  return any.visit([&visit](const auto& step) { return visit(step); });
}

/// By what factor a disturbance grows from steps 2000..6000 to steps 6000..10000: the ratio of the
/// largest values seen. A bounded swing gives 1, to 1e-6 or so: of 4000 samples of its phase one is
/// close to the top. The first 2000 steps let die what dies.
inline double growth(Method method, double zeta, double omega0_dt) {
  return with_step(method, [&](auto step) {
    const LinearContact scene{zeta};
    State<double> state{1, 0.5};
    double largest[2] = {0, 0};
    for (int i = 0; i < 10000; ++i) {
      step(scene, 0, state, omega0_dt);
      const double size = std::abs(state.position) + std::abs(state.velocity);
      if (!(size < 1e100)) return std::numeric_limits<double>::infinity();
      if (size < 1e-100) return 0.0;
      if (i >= 2000) largest[i >= 6000] = std::max(largest[i >= 6000], size);
    }
    return largest[1] / largest[0];
  });
}

/// The largest omega0 dt at which nothing grows, by bisection to 1e-6 and better.
inline double measured_limit(Method method, double zeta) {
  double stable = 1e-3, unstable = 4;
  while (unstable - stable > 1e-7) {
    const double middle = (stable + unstable) / 2;
    (growth(method, zeta, middle) > 1 + 1e-5 ? unstable : stable) = middle;
  }
  return (stable + unstable) / 2;
}

struct RestitutionRange {
  double lowest, highest;
};

/// The restitution of one bounce off the wall, at so many phases of the step grid. What has not
/// left by t = 100 is at rest.
inline RestitutionRange restitution_range(Method method, const Wall& wall, double omega0_dt,
                                          int phases) {
  RestitutionRange range{1e9, 0};
  for (int phase = 0; phase < phases; ++phase) {
    with_step(method, [&](auto step) {
      State<double> state{(phase + 0.5) / phases * omega0_dt, -1};
      int steps = 0;
      do step(wall, 0, state, omega0_dt);
      while ((state.position < 0 || state.velocity < 0) && ++steps * omega0_dt < 100);
      range.lowest = std::min(range.lowest, state.velocity);
      range.highest = std::max(range.highest, state.velocity);
    });
  }
  return range;
}

}  // namespace bounce::hard_cases

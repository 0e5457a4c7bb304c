#pragma once
#include "physics/methods/method.hpp"
#include "physics/stability.hpp"
#include "physics/state.hpp"

namespace bounce {

/// The classical Runge-Kutta method (Kutta 1901): the slope at the start, twice in the middle, and
/// at the end, averaged 1 : 2 : 2 : 1. Order 4, for four force evaluations a step.
template <class Scene, class Vector>
void rk4(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector v1 = state.velocity;
  const Vector a1 = scene.acceleration(t, state);
  const State<Vector> middle{state.position + v1 * (dt / 2), state.velocity + a1 * (dt / 2)};

  const Vector v2 = middle.velocity;
  const Vector a2 = scene.acceleration(t + dt / 2, middle);
  const State<Vector> again{state.position + v2 * (dt / 2), state.velocity + a2 * (dt / 2)};

  const Vector v3 = again.velocity;
  const Vector a3 = scene.acceleration(t + dt / 2, again);
  const State<Vector> end{state.position + v3 * dt, state.velocity + a3 * dt};

  const Vector v4 = end.velocity;
  const Vector a4 = scene.acceleration(t + dt, end);
  state.position += (v1 + 2 * v2 + 2 * v3 + v4) * (dt / 6);
  state.velocity += (a1 + 2 * a2 + 2 * a3 + a4) * (dt / 6);
}

namespace methods {
inline constexpr Method rk4{.name = "rk4",
                            .about = "classical Runge-Kutta: four looks at the force a step",
                            .order = 4,
                            .evaluations = 4,
                            .mark = Mark::diamond,
                            .stability_limit = rk4_limit};
}  // namespace methods

struct Rk4 {
  static constexpr Method facts = methods::rk4;

  template <class Scene, class Vector>
  void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
    rk4(scene, t, state, dt);
  }
};

}  // namespace bounce

#pragma once
#include "physics/methods/method.hpp"
#include "physics/stability.hpp"
#include "physics/state.hpp"

namespace bounce {

/// The lecture's formulas: v(t+dt) = v(t) + a(t) dt,  y(t+dt) = y(t) + v(t) dt.
/// Order 1. On an undamped spring its energy grows for every dt (stability.hpp).
// [explicit_euler]
template <class Scene, class Vector>
void explicit_euler(const Scene& scene, double t, State<Vector>& state, double dt) {
  const auto& acceleration = scene.acceleration(t, state);
  state.position += state.velocity * dt;  // with the velocity from before the step
  state.velocity += acceleration * dt;
}
// [explicit_euler]

namespace methods {
inline constexpr Method explicit_euler{
    .name = "explicit-euler",
    .about = "position and velocity by what they were before the step",
    .order = 1,
    .evaluations = 1,
    .mark = Mark::triangle,
    .stability_limit = explicit_euler_limit};
}  // namespace methods

struct ExplicitEuler {
  static constexpr Method facts = methods::explicit_euler;

  template <class Scene, class Vector>
  void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
    explicit_euler(scene, t, state, dt);
  }
};

}  // namespace bounce

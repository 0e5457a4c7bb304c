#pragma once
#include "physics/methods/method.hpp"
#include "physics/stability.hpp"
#include "physics/state.hpp"

namespace bounce {

/// The lecture's program: velocity first, then position with the *new* velocity (also called
/// symplectic Euler). Order 1 as well, but on an undamped spring the energy stays in a band.
// [semi_implicit_euler]
template <class Scene, class Vector>
void semi_implicit_euler(const Scene& scene, double t, State<Vector>& state, double dt) {
  state.velocity += scene.acceleration(t, state) * dt;
  state.position += state.velocity * dt;
}
// [semi_implicit_euler]

namespace methods {
inline constexpr Method semi_implicit_euler{
    .name = "semi-implicit-euler",
    .about = "velocity first, then position with the new velocity: the loop",
    .order = 1,
    .evaluations = 1,
    .stability_limit = semi_implicit_euler_limit};
}  // namespace methods

struct SemiImplicitEuler {
  static constexpr Method facts = methods::semi_implicit_euler;

  template <class Scene, class Vector>
  void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
    semi_implicit_euler(scene, t, state, dt);
  }
};

}  // namespace bounce

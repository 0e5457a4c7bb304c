#pragma once
#include <optional>

#include "physics/methods/method.hpp"
#include "physics/stability.hpp"
#include "physics/state.hpp"

namespace bounce {

namespace methods {
inline constexpr Method velocity_verlet{
    .name = "velocity-verlet",
    .about = "half a kick, a drift, half a kick, as molecular dynamics does it",
    .order = 2,
    .evaluations = 1,
    .mark = Mark::square,
    .stability_limit = semi_implicit_euler_limit};
}  // namespace methods

/// Velocity Verlet as molecular dynamics programs write it (LAMMPS, `fix nve`): half a kick, a
/// drift, half a kick. Order 2 when the acceleration depends on the position alone. A damper sees
/// the velocity of the half step, which costs an order: 1 in a damped contact.
/// The acceleration at the end of a step starts the next one, so it is part of the method's state.
template <class Vector>
struct VelocityVerlet {
  static constexpr Method facts = methods::velocity_verlet;

  std::optional<Vector> acceleration;  // at the end of the last step; empty before the first

  // [velocity_verlet]
  template <class Scene>
  void operator()(const Scene& scene, double t, State<Vector>& state, double dt) {
    if (!acceleration) acceleration = scene.acceleration(t, state);
    state.velocity += *acceleration * (dt / 2);
    state.position += state.velocity * dt;
    *acceleration = scene.acceleration(t + dt, state);
    state.velocity += *acceleration * (dt / 2);
  }
  // [velocity_verlet]

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit("acceleration", self.acceleration);
  }
};

}  // namespace bounce

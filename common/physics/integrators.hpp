#pragma once
#include <optional>

#include "physics/state.hpp"

namespace bounce {

// Four ways to move a state forward by one time step `dt` [s]. A scene tells the acceleration,
//
//   Vector scene.acceleration(double t, const State<Vector>& state) const     [m/s^2]
//
// and the method moves time. All four solve the same equation, x'' = a(t, x, x'); they differ in
// when they ask for the acceleration, and so in what an error of theirs looks like.
// "Order p" means: halve dt, and the error after a given time falls by 2^p - as long as the
// acceleration is smooth. A touch of the floor is not smooth (docs/02_spring_floor.md).

/// The formulas of the slides: v(t+dt) = v(t) + a(t) dt,  y(t+dt) = y(t) + v(t) dt.
/// Order 1. On an undamped spring its energy grows for every dt (stability.hpp).
// [explicit_euler]
template <class Scene, class Vector>
void explicit_euler(const Scene& scene, double t, State<Vector>& state, double dt) {
  const auto& acceleration = scene.acceleration(t, state);
  state.position += state.velocity * dt;  // with the velocity from before the step
  state.velocity += acceleration * dt;
}
// [explicit_euler]

/// The program of the slides: velocity first, then position with the *new* velocity (also called
/// symplectic Euler). Order 1 as well, but on an undamped spring the energy stays in a band.
// [semi_implicit_euler]
template <class Scene, class Vector>
void semi_implicit_euler(const Scene& scene, double t, State<Vector>& state, double dt) {
  state.velocity += scene.acceleration(t, state) * dt;
  state.position += state.velocity * dt;
}
// [semi_implicit_euler]

/// Velocity Verlet as molecular dynamics programs write it (LAMMPS, `fix nve`): half a kick, a
/// drift, half a kick. Order 2 when the acceleration depends on the position alone. A damper sees
/// the velocity of the half step, which costs an order: 1 in a damped contact.
/// The acceleration at the end of a step starts the next one, so it is part of the method's state.
template <class Vector>
struct VelocityVerlet {
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
};

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

}  // namespace bounce

#pragma once
#include <vector>

#include "physics/energy.hpp"
#include "physics/parameters.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Stage 1. A ball in free fall: the only force is gravity. One dimension, y is up.
struct FreeFall {
  double mass = 1.0;              // kg
  double gravity = 9.81;          // m/s^2
  State<double> start{5.0, 0.0};  // m, m/s

  // [force]
  double force(double /*t*/, const State<double>& /*state*/) const {
    return -mass * gravity;  // downwards, so negative: y is up
  }
  // [force]

  // [acceleration]
  double acceleration(double t, const State<double>& state) const {
    return force(t, state) / mass;  // F = m a, read as cause and effect
  }
  // [acceleration]

  Energy energy(const State<double>& state) const {
    return {kinetic_energy(mass, state.velocity),
            gravitational_energy(mass, gravity, state.position), 0};
  }

  std::vector<Parameter> parameters() {
    return {describe::mass(mass), describe::gravity(gravity), describe::position(start.position, 5),
            describe::velocity(start.velocity)};
  }
};

/// The loop, once around: force -> acceleration -> velocity -> position. It does not know which
/// force it is, and so it lives in common/physics/methods/semi_implicit_euler.hpp, under its name
/// in the field: semi_implicit_euler. A test shows that the two are equal to the bit.
// [loop]
template <class Scene, class Vector>
void fall_one_step(const Scene& scene, double t, State<Vector>& state, double dt) {
  const Vector acceleration = scene.acceleration(t, state);  // from the force
  state.velocity += acceleration * dt;                       // acceleration changes velocity
  state.position += state.velocity * dt;                     // velocity changes position
}
// [loop]

}  // namespace bounce

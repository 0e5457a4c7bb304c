#pragma once
#include <algorithm>
#include <vector>

#include "physics/contact.hpp"
#include "physics/energy.hpp"
#include "physics/parameters.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Stage 3. A damper beside the spring brakes the ball while it touches, and the bounces die out.
struct Damping {
  double mass = 1.0;       // kg
  double gravity = 9.81;   // m/s^2
  double radius = 0.1;     // m
  double stiffness = 1e4;  // N/m
  double damping = 5.0;    // N s/m
  ContactLaw contact = ContactLaw::may_pull;
  State<double> start{1.0, 0.0};  // m, m/s

  // [force]
  double force(double /*t*/, const State<double>& state) const {
    const double y = state.position, v = state.velocity;
    // Gravity, downwards.
    double force = -mass * gravity;
    // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
    if (y < radius) {
      double push = stiffness * (radius - y) - damping * v;
      if (contact == ContactLaw::push_only) push = std::max(0.0, push);
      force += push;
    }
    return force;
  }
  // [force]

  double acceleration(double t, const State<double>& state) const { return force(t, state) / mass; }

  double overlap(const State<double>& state) const {
    return std::max(0.0, radius - state.position);
  }
  double spring_force(double /*t*/, const State<double>& state) const {
    return stiffness * overlap(state);
  }

  Energy energy(const State<double>& state) const {
    return {kinetic_energy(mass, state.velocity),
            gravitational_energy(mass, gravity, state.position),
            spring_energy(stiffness, overlap(state))};
  }

  std::vector<Parameter> parameters() {
    return {describe::mass(mass),
            describe::gravity(gravity),
            describe::position(start.position, 1.2),
            describe::velocity(start.velocity),
            describe::radius(radius),
            describe::stiffness(stiffness),
            describe::damping(damping),
            describe::contact(contact)};
  }
};

}  // namespace bounce

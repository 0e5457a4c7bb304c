// Your turn, stage 3: the bounces die out. Edit mine.hpp (./course check 3 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 3, or once ./course check 3 --watch.
// The lesson: docs/03_damping.md. Stuck? ./course check 3 --hint
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
  // YOUR TURN: the force on the ball [N], upwards positive. (Lesson: "The idea")
  // You have: what stage 2 had, damping [N s/m], and state.velocity [m/s], upwards positive.
  // Must hold: as in stage 2, and while the ball overlaps the floor (y < radius, not at y = radius)
  // a damper brakes it with damping times its velocity, against the velocity.
  // If contact == ContactLaw::push_only, spring and damper together never pull: their sum is at
  // least 0. (Lesson: "The slides' damper can pull".) Gravity is no part of that sum.
  double force(double /*t*/, [[maybe_unused]] const State<double>& state) const {
    return 0;  // <- here
  }
  // [force]

  double acceleration(double t, const State<double>& state) const { return force(t, state) / mass; }

  /// The part of the force that is neither gravity nor spring. In a push-only contact that has let
  /// go it takes all of the spring's force away.
  double damper_force(double t, const State<double>& state) const {
    if (!(state.position < radius)) return 0;
    return force(t, state) + mass * gravity - stiffness * (radius - state.position);
  }

  Energy energy(const State<double>& state) const {
    return {kinetic_energy(mass, state.velocity),
            gravitational_energy(mass, gravity, state.position),
            spring_energy(stiffness, radius - state.position)};
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

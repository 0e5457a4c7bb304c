// Your turn, stage 2: the ball bounces. Edit mine.hpp (./course check 2 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 2, or once ./course check 2 --watch.
// The lesson: docs/02_spring_floor.md. Stuck? ./course check 2 --hint
#pragma once
#include <vector>

#include "physics/energy.hpp"
#include "physics/parameters.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Stage 2. The ball falls on a floor at height 0 and is pushed back by a spring.
struct SpringFloor {
  double mass = 1.0;              // kg
  double gravity = 9.81;          // m/s^2
  double radius = 0.1;            // m
  double stiffness = 1e4;         // N/m
  State<double> start{1.0, 0.0};  // m, m/s

  // [force]
  // YOUR TURN: the force on the ball [N], upwards positive. (Lesson: "The idea")
  // You have: mass [kg], gravity [m/s^2], radius [m], stiffness [N/m], and state.position [m], the
  // height of the ball's centre. The floor is at height 0.
  // Must hold: gravity acts always. While the ball overlaps the floor (its centre is below the
  // height of its radius) a spring pushes upwards, too, with stiffness times the overlap.
  double force(double /*t*/, [[maybe_unused]] const State<double>& state) const {
    return 0;  // <- here
  }
  // [force]

  double acceleration(double t, const State<double>& state) const { return force(t, state) / mass; }

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
            describe::stiffness(stiffness)};
  }
};

}  // namespace bounce

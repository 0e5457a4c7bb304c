// Your turn, stage 4: the ball flies in space. Edit mine.hpp (./course check 4 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 4, or once ./course check 4 --watch.
// The lesson: docs/04_three_dimensions.md. Stuck? ./course check 4 --hint
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "physics/components.hpp"
#include "physics/contact.hpp"
#include "physics/energy.hpp"
#include "physics/parameters.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Stage 4. The ball of stage 3, thrown into space: position, velocity and force are vectors. y is
/// up, and the floor is the plane y = 0. It is frictionless: it pushes along y only.
struct ThreeDimensions {
  double mass = 1.0;       // kg
  double gravity = 9.81;   // m/s^2
  double radius = 0.1;     // m
  double stiffness = 1e4;  // N/m
  double damping = 5.0;    // N s/m
  ContactLaw contact = ContactLaw::may_pull;
  bool floor = true;
  State<Eigen::Vector3d> start{{0.0, 1.0, 0.0}, {1.0, 0.0, 0.5}};  // m, m/s

  // [force]
  // YOUR TURN 1 of 2: the force on the ball [N], a vector. (Lesson: "The idea")
  // You have: what stage 3 had, state.position and state.velocity as vectors with .x() .y() .z(),
  // and `floor`: whether there is one. y is up.
  // Must hold: gravity acts along y and nowhere else. The floor, where there is one, is
  // frictionless: spring and damper act along y, as in stage 3, with contact push_only too.
  Eigen::Vector3d force(double /*t*/, [[maybe_unused]] const State<Eigen::Vector3d>& state) const {
    return {0, 0, 0};  // <- here
  }
  // [force]

  // [acceleration]
  // YOUR TURN 2 of 2: the acceleration [m/s^2]. (Lesson: "The program")
  // Must hold: F = m a, for the whole vector.
  Eigen::Vector3d acceleration([[maybe_unused]] double t,
                               [[maybe_unused]] const State<Eigen::Vector3d>& state) const {
    return {0, 0, 0};  // <- here
  }
  // [acceleration]

  /// The part of the force that is neither gravity nor spring.
  Eigen::Vector3d damper_force(double t, const State<Eigen::Vector3d>& state) const {
    const double push = force(t, state).y() + mass * gravity;
    return {0, push - spring_force(state), 0};
  }
  double spring_force(const State<Eigen::Vector3d>& state) const {
    return stiffness * overlap(state);
  }
  double overlap(const State<Eigen::Vector3d>& state) const {
    return floor ? std::max(0.0, radius - state.position.y()) : 0;
  }

  Energy energy(const State<Eigen::Vector3d>& state) const {
    return {kinetic_energy(mass, state.velocity),
            gravitational_energy(mass, gravity, state.position.y()),
            spring_energy(stiffness, overlap(state))};
  }

  std::vector<Parameter> parameters() {
    return {describe::mass(mass),
            describe::gravity(gravity),
            describe::position(components(start.position), 2),
            describe::velocity(components(start.velocity)),
            describe::radius(radius),
            describe::stiffness(stiffness),
            describe::damping(damping),
            describe::contact(contact),
            describe::floor(floor)};
  }
};

}  // namespace bounce

// Your turn, stage 7: the floor leans. Edit mine.hpp (./course check 7 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 7, or once ./course check 7 --watch.
// The lesson: docs/07_tilted_plane.md. Stuck? ./course check 7 --hint
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "physics/components.hpp"
#include "physics/contact.hpp"
#include "physics/energy.hpp"
#include "physics/parameters.hpp"
#include "physics/shapes.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Stage 7. The floor is any plane a x + b y + c z + d = 0. It is frictionless: it pushes along its
/// normal (a, b, c) only, to the side where the normal points.
struct TiltedPlane {
  double mass = 1.0;       // kg
  double gravity = 9.81;   // m/s^2
  double radius = 0.1;     // m
  double stiffness = 1e4;  // N/m
  double damping = 5.0;    // N s/m
  ContactLaw contact = ContactLaw::may_pull;
  Eigen::Vector3d normal{0.17633, 1, 0};  // a, b, c: any length but zero; here tilted by 10 degrees
  double offset = 0;                      // d, in the unit that makes the equation true
  State<Eigen::Vector3d> start{{0, 0.6015, 0}, {0, 0, 0}};  // m, m/s: falls by 0.5 m to the touch

  // [plane]
  // YOUR TURN 1 of 2: the same plane, with a normal of length 1. (Lesson: "A normal must have
  // length 1") You have: normal (a, b, c), of any length but zero, and offset d, of a x + b y + c z
  // + d = 0. Must hold: both sides of the equation are divided by the length of the normal,
  // `normal.norm()`. (Plane::from_equation does that. Write it out once: return {the new normal,
  // the new offset}.)
  Plane plane() const {
    return {{0, 0, 0}, 0};  // <- here
  }
  // [plane]

  // [force]
  // YOUR TURN 2 of 2: the force on the ball [N]. (Lesson: "The idea")
  // You have: what stage 4 had, and plane() from above: plane().normal and plane().offset.
  // Must hold: the distance of the ball's centre from the plane is n . p + d, negative behind it;
  // its velocity away from the plane is n . v; and while distance < radius spring and damper push
  // along n, frictionless. Gravity goes on acting along y.
  Eigen::Vector3d force(double /*t*/, [[maybe_unused]] const State<Eigen::Vector3d>& state) const {
    return {0, 0, 0};  // <- here
  }
  // [force]

  Eigen::Vector3d acceleration(double t, const State<Eigen::Vector3d>& state) const {
    return force(t, state) / mass;
  }

  /// The part of the force that is neither gravity nor spring.
  Eigen::Vector3d damper_force(double t, const State<Eigen::Vector3d>& state) const {
    const Eigen::Vector3d weight(0, -mass * gravity, 0);
    return force(t, state) - weight - spring_force(state);
  }
  Eigen::Vector3d spring_force(const State<Eigen::Vector3d>& state) const {
    return stiffness * overlap(state) * plane().normal;
  }
  double overlap(const State<Eigen::Vector3d>& state) const {
    return std::max(0.0, radius - plane().distance(state.position));
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
            describe::normal(components(normal)),
            describe::offset(offset)};
  }
};

}  // namespace bounce

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
  Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
    const double y = state.position.y(), v = state.velocity.y();
    // Gravity, downwards.
    Eigen::Vector3d force(0, -mass * gravity, 0);
    // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
    if (floor && y < radius) {
      double push = stiffness * (radius - y) - damping * v;
      if (contact == ContactLaw::push_only) push = std::max(0.0, push);
      force.y() += push;
    }
    return force;
  }
  // [force]

  // [acceleration]
  Eigen::Vector3d acceleration(double t, const State<Eigen::Vector3d>& state) const {
    return force(t, state) / mass;
  }
  // [acceleration]

  double overlap(const State<Eigen::Vector3d>& state) const {
    return floor ? std::max(0.0, radius - state.position.y()) : 0;
  }
  Eigen::Vector3d spring_force(double /*t*/, const State<Eigen::Vector3d>& state) const {
    return {0, stiffness * overlap(state), 0};
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

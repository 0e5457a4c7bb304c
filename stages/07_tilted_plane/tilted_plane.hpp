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
  /// The plane with a normal of unit length: only that makes d(p) below a distance in metres.
  Plane plane() const { return Plane::from_equation(normal, offset); }
  // [plane]

  // [force]
  Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
    // Distance of the centre from the plane, and velocity away from it.
    const auto [n, d] = plane();
    const double y = dot(n, state.position) + d, v = dot(n, state.velocity);
    // Gravity, downwards.
    Eigen::Vector3d force(0, -mass * gravity, 0);
    // Only while the ball overlaps the plane: a spring, and a damper against the velocity.
    if (y < radius) {
      double push = stiffness * (radius - y) - damping * v;
      if (contact == ContactLaw::push_only) push = std::max(0.0, push);
      force += push * n;  // along the normal
    }
    return force;
  }
  // [force]

  Eigen::Vector3d acceleration(double t, const State<Eigen::Vector3d>& state) const {
    return force(t, state) / mass;
  }

  double overlap(const State<Eigen::Vector3d>& state) const {
    return std::max(0.0, radius - plane().distance(state.position));
  }
  Eigen::Vector3d spring_force(double /*t*/, const State<Eigen::Vector3d>& state) const {
    return stiffness * overlap(state) * plane().normal;
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

#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/contact.hpp"
#include "physics/energy.hpp"
#include "physics/parameters.hpp"
#include "physics/state.hpp"

namespace bounce {

/// What the contact knows of the floor's movement.
enum class FloorLaw {
  relative,     // where the floor is, and how fast: the damper acts on the relative velocity
  absolute,     // where it is; the damper brakes the ball's own velocity
  fixed_switch  // the lecture's program word for word: the ball is in contact while y < r
};

/// Stage 6. The floor of stage 3 moves up and down under the ball.
struct OscillatingFloor {
  double mass = 1.0;       // kg
  double gravity = 9.81;   // m/s^2
  double radius = 0.1;     // m
  double stiffness = 1e4;  // N/m
  double damping = 14.17;  // N s/m: restitution 0.8
  ContactLaw contact = ContactLaw::may_pull;
  double amplitude = 0.06;          // m
  double angular_frequency = 12.6;  // rad/s: about 2 Hz
  double phase = 0;                 // rad
  double floor_velocity = 0;        // m/s
  FloorLaw floor_law = FloorLaw::relative;
  State<double> start{0.8, 0.0};  // m, m/s

  // [floor]
  double floor_height(double t) const {
    return floor_velocity * t + amplitude * std::sin(angular_frequency * t + phase);
  }
  // Its derivative.
  double floor_speed(double t) const {
    return floor_velocity + amplitude * angular_frequency * std::cos(angular_frequency * t + phase);
  }
  // [floor]

  // [force]
  double force(double t, const State<double>& state) const {
    const double y = state.position, v = state.velocity;
    const double floor = floor_height(t);
    // Gravity, downwards.
    double force = -mass * gravity;
    // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
    if (touches(y, floor)) {
      double push = stiffness * (radius - y + floor) - damping * damped_velocity(t, v);
      if (contact == ContactLaw::push_only) push = std::max(0.0, push);
      force += push;
    }
    return force;
  }
  // [force]

  // [laws]
  bool touches(double y, double floor) const {
    // The slides' switch: wherever the floor is.
    if (floor_law == FloorLaw::fixed_switch) return y < radius;
    return y - floor < radius;
  }
  double damped_velocity(double t, double v) const {
    if (floor_law == FloorLaw::relative) return v - floor_speed(t);
    // Whatever the floor does.
    return v;
  }
  // [laws]

  double acceleration(double t, const State<double>& state) const { return force(t, state) / mass; }

  /// How far the spring is pressed in [m]; negative when the slides' switch stretches it.
  double compression(double t, double y) const {
    const double floor = floor_height(t);
    return touches(y, floor) ? radius - y + floor : 0;
  }

  double spring_force(double t, const State<double>& state) const {
    return stiffness * compression(t, state.position);
  }

  Energy energy(double t, const State<double>& state) const {
    const double d = compression(t, state.position);
    return {kinetic_energy(mass, state.velocity),
            gravitational_energy(mass, gravity, state.position), stiffness * d * d / 2};
  }

  std::vector<Parameter> parameters() {
    const Range not_negative{0, 1e30}, any{-1e15, 1e15};
    return {
        describe::mass(mass),
        describe::gravity(gravity),
        describe::position(start.position, 1.2),
        describe::velocity(start.velocity),
        describe::radius(radius),
        describe::stiffness(stiffness),
        describe::damping(damping),
        describe::contact(contact),
        {"amplitude", "m", "how far the floor swings to each side", &amplitude, not_negative,
         Range{0, 0.15}},
        {"angular_frequency", "rad/s", "how fast the floor swings; 6.283 is once a second",
         &angular_frequency, not_negative, Range{0, 40}},
        {"phase", "rad", "where in its swing the floor starts", &phase, any, Range{0, 6.283}, true},
        {"floor_velocity", "m/s", "steady speed of the floor, upwards, besides the swing",
         &floor_velocity, any, Range{-1, 1}, true},
        {"floor_law", "", "what the contact knows of the floor's movement",
         choice_of(floor_law, {"relative", "absolute", "fixed-switch"})}};
  }
};

}  // namespace bounce

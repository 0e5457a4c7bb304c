// Your turn, stage 6: the floor moves. Edit mine.hpp (./course check 6 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 6, or once ./course check 6 --watch.
// The lesson: docs/06_oscillating_floor.md. Stuck? ./course check 6 --hint
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
  // YOUR TURN 1 of 3: where the floor is [m], and how fast it moves [m/s]. (Lesson: "The idea")
  // You have: floor_velocity [m/s], amplitude [m], angular_frequency [rad/s], phase [rad]; t [s].
  // Must hold: a steady movement from height 0 plus a swing A sin(w t + phase); and the speed is
  // the derivative of the height.
  double floor_height([[maybe_unused]] double t) const {
    return 0;  // <- here
  }
  double floor_speed([[maybe_unused]] double t) const {
    return 0;  // <- and here
  }
  // [floor]

  // [force]
  // YOUR TURN 2 of 3: the force on the ball [N]. (Lesson: "The program")
  // You have: what stage 3 had; floor_height(t) from above; touches and damped_velocity from below.
  // Must hold: as in stage 3, seen from a floor that is at floor_height(t). The ball is in contact
  // while touches(y, floor); the overlap is measured from where the floor is; the damper brakes
  // damped_velocity(t, v).
  double force([[maybe_unused]] double t, [[maybe_unused]] const State<double>& state) const {
    return 0;  // <- here
  }
  // [force]

  // [laws]
  // YOUR TURN 3 of 3: what the contact knows of the floor's movement. (Lesson: "Is the claim
  // true?")
  //   floor_law             in contact while                   the damper brakes
  //   FloorLaw::relative    ball and floor overlap (not = )    the velocity between the two
  //   FloorLaw::absolute    the same                           the ball's own velocity
  //   FloorLaw::fixed_switch      y < radius, wherever the floor is  the ball's own velocity
  bool touches([[maybe_unused]] double y, [[maybe_unused]] double floor) const {
    return false;  // <- here
  }
  double damped_velocity([[maybe_unused]] double t, [[maybe_unused]] double v) const {
    return 0;  // <- and here
  }
  // [laws]

  double acceleration(double t, const State<double>& state) const { return force(t, state) / mass; }

  /// How far the spring is pressed in [m]; negative when the slides' switch stretches it.
  double compression(double t, double y) const {
    const double floor = floor_height(t);
    return touches(y, floor) ? radius - y + floor : 0;
  }

  /// The part of the force that is neither gravity nor spring.
  double damper_force(double t, const State<double>& state) const {
    if (!touches(state.position, floor_height(t))) return 0;
    return force(t, state) + mass * gravity - stiffness * compression(t, state.position);
  }

  // Power [W]. The contact is squeezed at the relative velocity, whatever its law says: what the
  // damper takes there is lost, and the floor gives the contact force times its own speed.
  double damper_power(double t, const State<double>& state) const {
    return -damper_force(t, state) * (state.velocity - floor_speed(t));
  }
  double floor_power(double t, const State<double>& state) const {
    return (force(t, state) + mass * gravity) * floor_speed(t);
  }

  Energy energy(double t, const State<double>& state) const {
    const double d = compression(t, state.position);
    return {kinetic_energy(mass, state.velocity),
            gravitational_energy(mass, gravity, state.position), stiffness * d * d / 2};
  }

  std::vector<Parameter> parameters();
};

inline std::vector<Parameter> OscillatingFloor::parameters() {
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

}  // namespace bounce

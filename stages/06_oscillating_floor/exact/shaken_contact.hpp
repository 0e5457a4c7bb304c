#pragma once
#include <cmath>
#include <limits>

#include "06_oscillating_floor/exact/swinging_floor.hpp"

namespace bounce {

/// The ball in contact with the floor: an oscillator that the floor shakes. The law, the movement
/// in closed form, and its two parts: one that follows the floor, and a free one that the damper
/// lets die.
struct ShakenContact {
  explicit ShakenContact(const OscillatingFloor& the_scene)
      : scene(the_scene),
        floor(scene),
        relative(scene.floor_law == FloorLaw::relative),
        w(scene.angular_frequency),
        sag(scene.mass * scene.gravity / scene.stiffness),
        omega0(natural_frequency(scene.stiffness, scene.mass)),
        beta(scene.damping / (2 * scene.mass)),
        oscillator(omega0, beta, w) {
    // At resonance without a damper there is no steady answer. One rounding beside it, it is huge,
    // and bounds nothing: the search then goes by the other bound.
    const double detuning = (omega0 - w) * (omega0 + w);
    const double least = std::numeric_limits<double>::epsilon() * omega0 * omega0;
    answer = 1.0 / Complex(detuning != 0 ? detuning : least, 2 * beta * w);
    begin(0);
    shaking_size = std::abs(shaking);
    steady_size = std::abs(steady);
  }

  /// A phase begins at `t`; the times below count from here.
  void begin(double t) {
    floor.begin(t);
    shaking =
        Complex(scene.stiffness, relative ? scene.damping * w : 0) * floor.swing() / scene.mass;
    steady = shaking * answer;
  }

  /// Spring and damper together [N]; a contact that only pushes acts while this is positive.
  double push(const FloorMovement& at, const State<double>& state) const {
    const double damped = state.velocity - (relative ? at.speed : 0);
    return scene.stiffness * (scene.radius - state.position + at.height) - scene.damping * damped;
  }

  double acceleration(const FloorMovement& at, const State<double>& state) const {
    return push(at, state) / scene.mass - scene.gravity;
  }
  /// Its rate [m/s^3].
  double jerk(const FloorMovement& at, const State<double>& state, double a) const {
    return (scene.stiffness * (at.speed - state.velocity) -
            scene.damping * (a - (relative ? at.acceleration : 0))) /
           scene.mass;
  }

  // The height that the spring would hold above the steadily moving floor: the oscillator swings
  // about it. An absolute damper under a moving floor weighs c u more.
  double rest_height() const {
    const double pressed = relative ? 0 : scene.damping * scene.floor_velocity;
    return floor.steady_height() + scene.radius - sag - pressed / scene.stiffness;
  }
  State<double> ball_at(const State<double>& start, double t, Complex turned) const {
    const double rest = rest_height(), u = scene.floor_velocity;
    const State<double> x =
        oscillator.move({start.position - rest, start.velocity - u}, shaking, t, turned);
    return {rest + u * t + x.position, u + x.velocity};
  }

  /// The part of the movement that does not follow the floor: distance [m] and velocity [m/s].
  State<double> free_part(const State<double>& ball, double t, Complex turned) const {
    const Complex answered = steady * turned;
    const double u = scene.floor_velocity;
    return {ball.position - rest_height() - u * t - answered.imag(),
            ball.velocity - u - w * answered.real()};
  }

  OscillatingFloor scene;
  SwingingFloor floor;
  bool relative;  // the damper knows the floor's speed
  double w;       // rad/s, of the floor
  double sag;     // m, of the spring under the ball's weight
  double omega0;  // rad/s, of the ball on the spring
  double beta;    // 1/s
  ForcedOscillator oscillator;
  Complex answer;           // steady / shaking [s^2]
  double shaking_size = 0;  // m/s^2
  double steady_size = 0;   // m
  // As of the phase's start:
  Complex shaking;  // what the oscillator feels of the swing, Im(shaking e^(i w t)) [m/s^2],
  Complex steady;   // and its steady answer, Im(steady e^(i w t)) [m]; huge at resonance
};

}  // namespace bounce

#pragma once
#include <cmath>

#include "06_oscillating_floor/exact/forced_oscillator.hpp"
#include "06_oscillating_floor/oscillating_floor.hpp"

namespace bounce {

/// The floor's height [m] and its first three derivatives.
struct FloorMovement {
  double height, speed, acceleration, jerk;
};

/// The floor's movement, with times that count from the start of a phase. The angle of its swing is
/// reduced to one turn, once: after hours w t is so large that its rounding would be all that a
/// search for a zero sees.
class SwingingFloor {
 public:
  explicit SwingingFloor(const OscillatingFloor& scene)
      : w_(scene.angular_frequency),
        phase_(scene.phase),
        amplitude_(scene.amplitude),
        velocity_(scene.floor_velocity) {}

  void begin(double t) {
    const double angle = w_ * t + phase_;
    swing_ = amplitude_ * Complex(std::cos(angle), std::sin(angle));  // these reduce exactly
    height_ = velocity_ * t;
  }

  /// e^(i w t)
  Complex turn(double t) const { return {std::cos(w_ * t), std::sin(w_ * t)}; }

  FloorMovement at(double t, Complex turned) const {
    const Complex swing = swing_ * turned;
    const double sine = swing.imag(), cosine = swing.real();
    return {height_ + velocity_ * t + sine, velocity_ + w_ * cosine, -w_ * w_ * sine,
            -w_ * w_ * w_ * cosine};
  }
  FloorMovement at(double t) const { return at(t, turn(t)); }
  FloorMovement at_start() const { return at(0, 1); }

  double steady_height() const { return height_; }  // m, at the phase's start, without the swing
  Complex swing() const { return swing_; }          // the swing is Im(swing e^(i w t)) [m]
  double top_acceleration() const { return amplitude_ * w_ * w_; }  // m/s^2

 private:
  double w_;          // rad/s
  double phase_;      // rad
  double amplitude_;  // m
  double velocity_;   // m/s
  double height_ = 0;
  Complex swing_;
};

}  // namespace bounce

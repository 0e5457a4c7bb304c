#pragma once
#include <cmath>
#include <numbers>

#include "06_oscillating_floor/exact/forced_oscillator.hpp"
#include "06_oscillating_floor/oscillating_floor.hpp"

namespace bounce {

/// An angle in [0, 2 pi).
inline double within_one_turn(double angle) {
  constexpr double turn = 2 * std::numbers::pi;
  const double rest = std::fmod(angle, turn);
  return rest < 0 ? rest + turn : rest;
}

/// The floor's height [m] and its first three derivatives.
struct FloorMovement {
  double height, speed, acceleration, jerk;
};

/// The floor's movement, with times that count from the start of a phase. The angle of its swing is
/// reduced to one turn, once: after hours w t is so large that its rounding would be all that a
/// search for a zero sees.
class SwingingFloor {
 public:
  explicit SwingingFloor(const OscillatingFloor& scene) : scene_(scene) {}

  void begin(double t) {
    const double angle = scene_.angular_frequency * t + scene_.phase;
    swing_ = scene_.amplitude * Complex(std::cos(angle), std::sin(angle));  // these reduce exactly
    height_ = scene_.floor_velocity * t;
  }

  /// e^(i w t)
  Complex turn(double t) const {
    const double angle = scene_.angular_frequency * t;
    return {std::cos(angle), std::sin(angle)};
  }

  FloorMovement at(double t, Complex turned) const {
    const Complex swing = swing_ * turned;
    const double sine = swing.imag(), cosine = swing.real();
    const double w = scene_.angular_frequency, u = scene_.floor_velocity;
    return {height_ + u * t + sine, u + w * cosine, -w * w * sine, -w * w * w * cosine};
  }
  FloorMovement at(double t) const { return at(t, turn(t)); }
  FloorMovement at_start() const { return at(0, 1); }

  double steady_height() const { return height_; }  // m, at the phase's start, without the swing
  Complex swing() const { return swing_; }          // the swing is Im(swing e^(i w t)) [m]
  double top_acceleration() const {                 // m/s^2
    return scene_.amplitude * scene_.angular_frequency * scene_.angular_frequency;
  }

 private:
  OscillatingFloor scene_;
  double height_ = 0;
  Complex swing_;
};

}  // namespace bounce

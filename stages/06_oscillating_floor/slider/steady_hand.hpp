#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "06_oscillating_floor/oscillating_floor.hpp"

namespace bounce {

/// An angle in [0, 2 pi).
inline double within_one_turn(double angle) {
  constexpr double turn = 2 * std::numbers::pi;
  const double rest = std::fmod(angle, turn);
  return rest < 0 ? rest + turn : rest;
}

/// The phase with which `after`, a floor whose amplitude or frequency was changed at the moment
/// `t`, goes on where `before` was. Without it the floor would jump: in A sin(w t + phase), a new w
/// changes the angle by t times the difference, which is many turns after a minute. So the angle is
/// kept when the frequency changes; when the amplitude does, the height is kept, and whether the
/// floor was rising. Only a floor that stands outside its new amplitude has to follow it inwards.
inline double phase_without_jump(const OscillatingFloor& before, const OscillatingFloor& after,
                                 double t) {
  const double angle = before.angular_frequency * t + before.phase;
  double wanted = angle;
  if (after.amplitude != before.amplitude && after.amplitude > 0) {
    const double sine = before.amplitude * std::sin(angle) / after.amplitude;
    wanted = std::asin(std::clamp(sine, -1.0, 1.0));
    if (std::cos(angle) < 0) wanted = std::numbers::pi - wanted;  // it was falling
  }
  return within_one_turn(wanted - after.angular_frequency * t);
}

}  // namespace bounce

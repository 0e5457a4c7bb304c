#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "06_oscillating_floor/exact/exact.hpp"
#include "run/one_ball_run.hpp"

namespace bounce {

using OscillatingFloorRun = OneBallRun<OscillatingFloor, OscillatingFloorExact>;

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

/// A slider moves. Amplitude and frequency take the phase along, so that the floor does not jump.
inline void set_without_jump(Simulation& simulation, const Parameter& parameter,
                             const std::string& text) {
  auto& run = run_as<OscillatingFloorRun>(simulation);
  const OscillatingFloor before = run.scene();
  parameter.set(text);
  if (parameter.name != "amplitude" && parameter.name != "angular_frequency") return;
  const double phase = phase_without_jump(before, run.scene(), run.time());
  find_parameter(run.parameters(), "phase").set(to_text(phase));
}

}  // namespace bounce

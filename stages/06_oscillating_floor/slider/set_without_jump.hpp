#pragma once
#include <string>

#include "06_oscillating_floor/exact/exact.hpp"
#include "06_oscillating_floor/oscillating_floor.hpp"
#include "06_oscillating_floor/slider/steady_hand.hpp"
#include "app/demo.hpp"
#include "run/one_ball_run.hpp"

namespace bounce {

/// A slider moves. Amplitude and frequency take the phase along, so that the floor does not jump.
inline void set_without_jump(Simulation& simulation, const Parameter& parameter,
                             const std::string& text) {
  auto& run = run_as<OneBallRun<OscillatingFloor, OscillatingFloorExact>>(simulation);
  const OscillatingFloor before = run.scene();
  parameter.set(text);
  if (parameter.name != "amplitude" && parameter.name != "angular_frequency") return;
  const double phase = phase_without_jump(before, run.scene(), run.time());
  find_parameter(run.parameters(), "phase").set(to_text(phase));
}

}  // namespace bounce

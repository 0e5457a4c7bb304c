#include "run/step_clock.hpp"

#include <algorithm>
#include <cmath>

namespace bounce {

void StepClock::restart() { now_ = {.dt = now_.dt}; }

void StepClock::start_grid_here() {
  now_.grid_start = now_.time;
  now_.grid_steps = 0;
  now_.into_step = 0;
}

void StepClock::go_to(double t, const TakeSteps& take) {
  // A target this close to a step's end (in steps) *is* the step's end: n dt is not exact.
  const double dt = now_.dt;
  const double n_target = (t - now_.grid_start) / dt;
  const double tolerance = 8e-16 * (std::abs(t) + std::abs(now_.grid_start)) / dt;

  if (now_.into_step > 0) {  // finish the step that was cut
    if (n_target < static_cast<double>(now_.grid_steps + 1) - tolerance) {
      const double part = t - now_.time;
      if (part > 0) take(1, now_.time, part);
      now_.into_step += std::max(0.0, part);
      now_.time = t;
      return;
    }
    take(1, now_.time, dt - now_.into_step);
    now_.into_step = 0;
    now_.time = grid_time(++now_.grid_steps);
  }
  const auto whole = static_cast<long long>(std::floor(n_target + tolerance)) - now_.grid_steps;
  if (whole > 0) {
    take(whole, grid_time(now_.grid_steps), dt);
    now_.grid_steps += whole;
    now_.time = grid_time(now_.grid_steps);
  }
  if (n_target > static_cast<double>(now_.grid_steps) + tolerance) {  // cut a step to land on t
    now_.into_step = t - now_.time;
    take(1, now_.time, now_.into_step);
  }
  now_.time = t;
}

}  // namespace bounce

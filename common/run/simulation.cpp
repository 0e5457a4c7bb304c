#include "run/simulation.hpp"

#include <algorithm>
#include <cmath>

namespace bounce {

void Simulation::use_method(Method method) {
  method_ = method;
  start_grid_here();
}

void Simulation::use_dt(double dt) {
  dt_ = dt;
  start_grid_here();
}

void Simulation::use_tolerance(double tolerance) {
  tolerance_ = tolerance;
  start_grid_here();
}

void Simulation::start_grid_here() {
  grid_start_ = time_;
  grid_steps_ = 0;
  into_step_ = 0;
  parameters_changed();
}

void Simulation::restart() {
  time_ = grid_start_ = into_step_ = 0;
  grid_steps_ = steps_ = 0;
  reset_state();
}

double Simulation::time_of_next_step() const { return grid_time(grid_steps_ + 1); }

void Simulation::advance_to(double t) {
  while (!advance_some(t)) {
  }
}

bool Simulation::advance_some(double t) {
  if (goes_by_events(method_)) {
    // A piece of the reference, a dozen evaluations of the law, takes the time of ten events.
    const double reached = go_by_events_towards(t, method_ == Method::exact ? 1000000 : 100000);
    if (!is_finite()) throw NonFinite(time_);
    time_ = reached;
    return reached == t;
  }
  // A million steps of one ball take less than a second in a debug build, too. Each portion costs a
  // copy of the state: with very many balls, ten steps are better than one.
  const auto n =
      static_cast<long long>(std::min(1e9, static_cast<double>(balls()) * pieces_per_step()));
  const long long steps = std::max({1LL, 1000000LL / n, std::min(10LL, 10000000LL / n)});
  take_steps_to(std::min(t, grid_time(grid_steps_ + steps)));
  return time_ >= t;
}

void Simulation::take_steps_to(double t) {
  // A target this close to a step's end (in steps) *is* the step's end: n dt is not exact.
  const double n_target = (t - grid_start_) / dt_;
  const double tolerance = 8e-16 * (std::abs(t) + std::abs(grid_start_)) / dt_;

  if (into_step_ > 0) {  // finish the step that was cut
    const double rest = dt_ - into_step_;
    if (n_target < static_cast<double>(grid_steps_ + 1) - tolerance) {
      const double part = t - time_;
      if (part > 0) take_checked_steps(1, time_, part);
      into_step_ += std::max(0.0, part);
      time_ = t;
      return;
    }
    take_checked_steps(1, time_, rest);
    into_step_ = 0;
    time_ = grid_time(++grid_steps_);
  }
  const auto whole = static_cast<long long>(std::floor(n_target + tolerance)) - grid_steps_;
  if (whole > 0) {
    take_checked_steps(whole, grid_time(grid_steps_), dt_);
    grid_steps_ += whole;
    time_ = grid_time(grid_steps_);
  }
  if (n_target > static_cast<double>(grid_steps_) + tolerance) {  // cut a step to land on t
    into_step_ = t - time_;
    take_checked_steps(1, time_, into_step_);
  }
  time_ = t;
}

void Simulation::take_checked_steps(long long count, double t, double dt) {
  constexpr long long stride = 1 << 14;  // the check for NaN costs nothing at this distance
  for (long long done = 0; done < count; done += stride) {
    const long long now = std::min(stride, count - done);
    const double t_now = t + static_cast<double>(done) * dt;
    const std::vector<double> before = numbers();
    take_steps(now, t_now, dt);
    if (!is_finite()) {
      // Again, one by one, to find the last good state.
      recall_numbers(before);
      for (long long i = 0; i < now; ++i) {
        const std::vector<double> good = numbers();
        const double t_good = t_now + static_cast<double>(i) * dt;
        take_steps(1, t_good, dt);
        if (!is_finite()) {
          recall_numbers(good);
          time_ = t_good;
          throw NonFinite(t_good);
        }
      }
    }
    steps_ += now;
  }
}

Simulation::Memory Simulation::memory() const {
  return {time_, dt_, tolerance_, grid_start_, into_step_, grid_steps_, steps_, numbers()};
}

namespace {

void check(const std::string& name, double value, Range valid) {
  if (valid.contains(value)) return;
  throw BadInput("its " + name + " is " + to_text(value) + ", and it must be from " +
                 to_text(valid.lowest) + " to " + to_text(valid.highest));
}

void check_ranges(const Simulation::Memory& memory) {
  check("dt", memory.dt, Simulation::valid_dt);
  check("tolerance", memory.tolerance, Simulation::valid_tolerance);
  check("time", memory.time, Simulation::valid_time);
  check("grid_start", memory.grid_start, Simulation::valid_time);
  check("grid_steps", static_cast<double>(memory.grid_steps), Simulation::valid_count);
  check("steps", static_cast<double>(memory.steps), Simulation::valid_count);
  check("into_step", memory.into_step, {0, memory.dt});
  for (std::size_t i = 0; i < memory.numbers.size(); ++i) {
    if (Simulation::valid_number.contains(memory.numbers[i])) continue;
    check("state's number " + std::to_string(i + 1), memory.numbers[i], Simulation::valid_number);
  }
}

}  // namespace

void Simulation::recall(const Memory& memory) {
  check_ranges(memory);
  const double grid_time =
      memory.grid_start + static_cast<double>(memory.grid_steps) * memory.dt + memory.into_step;
  const double blur = 1e-6 * memory.dt + 1e-12 * grid_time;
  if (!goes_by_events(method_) && std::abs(grid_time - memory.time) > blur) {
    throw BadInput(
        "its time is " + to_text(memory.time) +
        ", and it must be grid_start + grid_steps dt + into_step = " + to_text(memory.grid_start) +
        " + " + std::to_string(memory.grid_steps) + " * " + to_text(memory.dt) + " + " +
        to_text(memory.into_step) + " = " + to_text(grid_time));
  }
  time_ = memory.time;
  dt_ = memory.dt;
  tolerance_ = memory.tolerance;
  grid_start_ = memory.grid_start;
  into_step_ = memory.into_step;
  grid_steps_ = memory.grid_steps;
  steps_ = memory.steps;
  if (!recall_numbers(memory.numbers)) {
    throw BadInput("its state does not fit this stage and method");
  }
  compare_from_here();
}

}  // namespace bounce

#include "run/simulation.hpp"

#include <algorithm>
#include <cmath>

namespace bounce {

void Simulation::use_method(const Method& method) {
  method_ = method;
  start_grid_here();
}

void Simulation::use_dt(double dt) {
  clock_.set_dt(dt);
  start_grid_here();
}

void Simulation::use_tolerance(double tolerance) {
  tolerance_ = tolerance;
  start_grid_here();
}

void Simulation::start_grid_here() {
  clock_.start_grid_here();
  parameters_changed();
}

void Simulation::restart() {
  clock_.restart();
  reset_state();
}

void Simulation::advance_to(double t) {
  while (!advance_some(t)) {
  }
}

bool Simulation::advance_some(double t) {
  if (method_.goes_by_events) {
    // A piece of the reference, a dozen evaluations of the law, takes the time of ten events.
    const bool is_formula = method_ == methods::exact;
    const double reached = go_by_events_towards(t, is_formula ? 1000000 : 100000);
    clock_.set_time(reached);
    return reached == t;
  }
  // A million steps of one ball take less than a second in a debug build, too. Each portion costs a
  // copy of the state: with very many balls, ten steps are better than one.
  const Traits its = traits();
  const auto n =
      static_cast<long long>(std::min(1e9, static_cast<double>(its.balls) * its.pieces_per_step));
  const long long steps = std::max({1LL, 1000000LL / n, std::min(10LL, 10000000LL / n)});
  clock_.go_to(
      std::min(t, clock_.time_after(steps)),
      [this](long long count, double from, double dt) { take_checked_steps(count, from, dt); });
  return time() >= t;
}

void Simulation::take_checked_steps(long long count, double t, double dt) {
  constexpr long long stride = 1 << 14;  // the check for NaN costs nothing at this distance
  for (long long done = 0; done < count; done += stride) {
    const long long now = std::min(stride, count - done);
    const double t_now = t + static_cast<double>(done) * dt;
    const std::vector<double> before = numbers();
    if (!take_steps(now, t_now, dt)) {
      // Again, one by one, to find the last good state.
      recall_numbers(before);
      for (long long i = 0; i < now; ++i) {
        const std::vector<double> good = numbers();
        const double t_good = t_now + static_cast<double>(i) * dt;
        if (!take_steps(1, t_good, dt)) {
          recall_numbers(good);
          clock_.set_time(t_good);
          throw NonFinite(t_good);
        }
      }
    }
    clock_.count_steps(now);
  }
}

void Simulation::recall(const Memory& memory) {
  const auto check = [](const std::string& name, auto number, Range valid) {
    const auto value = static_cast<double>(number);
    if (valid.contains(value)) return;
    throw BadInput("its " + name + " is " + to_text(value) + ", and it must be from " +
                   to_text(valid.lowest) + " to " + to_text(valid.highest));
  };
  Memory::each(memory, check);
  for (std::size_t i = 0; i < memory.numbers.size(); ++i) {
    if (valid_number.contains(memory.numbers[i])) continue;
    check("state's number " + std::to_string(i + 1), memory.numbers[i], valid_number);
  }
  const double grid_time =
      memory.grid_start + static_cast<double>(memory.grid_steps) * memory.dt + memory.into_step;
  const double blur = 1e-6 * memory.dt + 1e-12 * grid_time;
  if (!method_.goes_by_events && std::abs(grid_time - memory.time) > blur) {
    throw BadInput(
        "its time is " + to_text(memory.time) +
        ", and it must be grid_start + grid_steps dt + into_step = " + to_text(memory.grid_start) +
        " + " + std::to_string(memory.grid_steps) + " * " + to_text(memory.dt) + " + " +
        to_text(memory.into_step) + " = " + to_text(grid_time));
  }
  clock_.recall(memory);
  tolerance_ = memory.tolerance;
  if (const std::string what = recall_numbers(memory.numbers); !what.empty()) {
    throw BadInput("its state does not fit this stage and method: " + what);
  }
  compare_from_here();
}

}  // namespace bounce

#pragma once
#include <functional>

namespace bounce {

/// Steps end at whole multiples of dt from where the grid was started, and at every time that is
/// asked for: a step is cut to land there, and its rest follows.
class StepClock {
 public:
  double time() const { return now_.time; }       // [s]
  double dt() const { return now_.dt; }           // [s]
  long long steps() const { return now_.steps; }  // since the start, cut ones too
  double time_of_next_step() const { return time_after(1); }
  /// The end of the step so many steps after the last whole one [s].
  double time_after(long long count) const { return grid_time(now_.grid_steps + count); }

  void restart();          // at 0
  void start_grid_here();  // the next step begins now
  void set_dt(double dt) { now_.dt = dt; }
  void set_time(double t) { now_.time = t; }  // for what moves without steps
  void count_steps(long long count) { now_.steps += count; }

  /// Goes to `t`. `take(count, t, dt)` takes so many steps of dt [s] from t on; it may throw.
  using TakeSteps = std::function<void(long long count, double t, double dt)>;
  void go_to(double t, const TakeSteps& take);

  /// All that it remembers.
  struct Memory {
    double time = 0;           // s
    double dt = 1e-3;          // s
    double grid_start = 0;     // steps end at grid_start + n dt
    double into_step = 0;      // how far beyond the last of these, when a step was cut [s]
    long long grid_steps = 0;  // n of the last one passed
    long long steps = 0;
  };
  const Memory& memory() const { return now_; }
  void recall(const Memory& memory) { now_ = memory; }

 private:
  double grid_time(long long n) const { return now_.grid_start + static_cast<double>(n) * now_.dt; }

  Memory now_;
};

}  // namespace bounce

#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "physics/energy.hpp"
#include "physics/parameters.hpp"
#include "run/methods.hpp"

namespace bounce {

/// The state stopped being a number. `t` is the time of the last good state.
struct NonFinite : std::runtime_error {
  explicit NonFinite(double t_last) : std::runtime_error("non-finite state"), t(t_last) {}
  double t;
};

/// The method has no formula for what comes next. `t` is how far it got.
struct NoClosedForm : std::runtime_error {
  NoClosedForm(double t_end, const std::string& why) : std::runtime_error(why), t(t_end) {}
  double t;
};

/// What the stiffest contact of a scene is like (contact.hpp), for warnings about the time step.
struct ContactNumbers {
  double omega0;  // rad/s
  double zeta;
};

/// Distance to the exact solution: of positions [m] and of velocities [m/s].
struct StateError {
  double position;
  double velocity;
};

/// A scene that runs: the scene's parameters, the state, the method and the clock. Command line,
/// headless run and window know stages through this class only; SceneSimulation
/// (scene_simulation.hpp) makes one from a scene.
class Simulation {
 public:
  virtual ~Simulation() = default;
  virtual std::unique_ptr<Simulation> clone() const = 0;

  // ---- What it is
  virtual std::vector<Parameter> parameters() = 0;  // they refer into this object
  virtual std::vector<Method> methods() const = 0;
  /// Throws BadInput where the chosen method cannot serve this scene.
  virtual void check_method() const {}
  virtual std::vector<std::string> columns() const = 0;  // of the trace, after `t`
  virtual std::optional<ContactNumbers> contact() const = 0;
  /// How fast something swings by itself [rad/s], whatever the contact: a floor. 0: nothing does.
  virtual double swing_rate() const { return 0; }

  // ---- Where it stands
  double time() const { return time_; }            // [s]
  double dt() const { return dt_; }                // [s]
  double tolerance() const { return tolerance_; }  // of `reference`
  Method method() const { return method_; }
  long long steps() const { return steps_; }  // since the start, shortened ones too

  /// Force evaluations besides the fixed number a step (methods.hpp): where events are located.
  virtual long long counted_force_evaluations() const { return 0; }
  virtual std::vector<double> values() const = 0;  // one trace row (or more) without `t`
  virtual std::vector<double> exact_values(double t) const = 0;  // the exact solution's; or empty
  virtual Energy energy() const = 0;                             // [J]
  virtual std::optional<StateError> error() const = 0;           // against the exact solution, now

  virtual std::size_t balls() const { return 1; }  // rows of the trace at one time
  /// Whether steps that are too long for a contact are cut there: then no step is too long.
  virtual bool cuts_steps() const { return false; }
  /// Into how many pieces a step may then be cut: what it can cost, in steps.
  virtual double pieces_per_step() const { return 1; }
  /// More words for the summary line, "name=value".
  virtual std::string summary() const { return ""; }
  /// The words on the command line, besides parameters, that make a run like this one.
  virtual std::string stage_options() const { return ""; }

  // ---- Setting it up. Method and time step may change in the middle of a run.
  virtual void use_seed(std::uint64_t /*seed*/) {}  // where a start has chance in it
  void use_method(Method method);
  void use_dt(double dt);
  void use_tolerance(double tolerance);
  void restart();  // from t = 0 and the scene's start

  /// Puts the ball somewhere else in the middle of a run: a trace row's values.
  virtual void place(const std::vector<double>& values) = 0;

  /// After a change of parameters in the middle of a run: the method forgets what it carried, and
  /// what is compared (exact solution, energy before) starts anew from here.
  virtual void parameters_changed() = 0;

  // ---- Moving. Steps end at whole multiples of dt, and at every time that is asked for: a step is
  // shortened to land there, and its rest follows. Throws NonFinite, and leaves the last good
  // state.
  void advance_to(double t);
  /// The same in portions of about a second at most, so that one can be heard in between. Returns
  /// whether it has arrived.
  bool advance_some(double t);
  void advance_one_step() { advance_to(time_of_next_step()); }
  double time_of_next_step() const;

  /// The next touch or lift-off [s], for the methods that go by events; else infinity.
  virtual double next_event() const = 0;

  // ---- Energy since the last restart or change of parameters [J]. Whatever is not here now and
  // was not taken by the damper is the method's error. On a moving floor, which gives and takes all
  // the time, the book opens anew with every touch. Keeping the damper's book costs as much as a
  // step, so that only the window does it.
  virtual void keep_energy_book(bool keep) = 0;
  virtual double energy_before() const = 0;                // and what a moving floor gave since
  virtual double energy_lost() const = 0;                  // to the damper; 0 while no book is kept
  virtual std::optional<double> exact_energy() const = 0;  // of the exact solution, now

  // ---- For `--save` and `--load`: all that the next step depends on, as plain numbers.
  struct Memory {
    double time, dt, tolerance, grid_start, into_step;
    long long grid_steps, steps;
    std::vector<double> numbers;  // state and the method's own memory
  };
  // What its clock may say; into_step: from 0 to dt. It has gone on from a start at 0 by steps.
  static constexpr Range valid_dt{1e-15, 1e15}, valid_tolerance{1e-15, 1}, valid_time{0, 1e15},
      valid_count{0, 1e18};
  // No run that begins with allowed parameters has such numbers, unless it explodes; beyond them
  // squares and products overflow, and a step may take for ever.
  static constexpr Range valid_number{-1e100, 1e100};
  Memory memory() const;
  void recall(const Memory& memory);  // throws BadInput when it does not fit

 protected:
  Simulation() = default;
  Simulation(const Simulation&) = default;
  Simulation& operator=(const Simulation&) = default;

  virtual void reset_state() = 0;        // to the scene's start
  virtual void compare_from_here() = 0;  // exact solution and energy book start anew
  virtual void take_steps(long long count, double t, double dt) = 0;
  /// Passes at most so many events. Returns the time that it has reached.
  virtual double go_by_events_towards(double t, long long most_events) = 0;
  virtual bool is_finite() const = 0;
  virtual std::vector<double> numbers() const = 0;
  virtual bool recall_numbers(const std::vector<double>& numbers) = 0;

 private:
  void start_grid_here();
  void take_steps_to(double t);
  void take_checked_steps(long long count, double t, double dt);
  double grid_time(long long n) const { return grid_start_ + static_cast<double>(n) * dt_; }

  Method method_ = Method::semi_implicit_euler;
  double dt_ = 1e-3;
  double tolerance_ = 1e-12;
  double time_ = 0;
  double grid_start_ = 0;     // steps end at grid_start_ + n dt_
  long long grid_steps_ = 0;  // n of the last grid point passed
  double into_step_ = 0;      // how far beyond it, when a step was shortened [s]
  long long steps_ = 0;
};

}  // namespace bounce

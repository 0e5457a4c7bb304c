#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "physics/contact.hpp"
#include "physics/energy.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/parameters.hpp"
#include "run/methods.hpp"
#include "run/step_clock.hpp"

namespace bounce {

/// The state stopped being a number. `t` is the time of the last good state.
struct NonFinite : std::runtime_error {
  explicit NonFinite(double t_last) : std::runtime_error("non-finite state"), t(t_last) {}
  double t;
};

/// The method has no formula for what comes next. `t` is how far it got.
struct NoClosedForm : TimeStandsStill {
  NoClosedForm(double t_end, const std::string& why)
      : TimeStandsStill(t_end, why,
                        "take a stepping method, such as --method semi-implicit-euler") {}
};

/// What the stiffest contact of a scene is like (contact.hpp), for warnings about the time step.
struct ContactNumbers {
  double omega0;  // rad/s
  double zeta;
  ContactLaw law = ContactLaw::may_pull;
  bool operator==(const ContactNumbers&) const = default;
};

/// Distance to the exact solution: of positions [m] and of velocities [m/s].
struct StateError {
  double position;
  double velocity;
};

/// Energy since the last restart or change of parameters [J]. Whatever is not here now and was not
/// taken by the damper is the method's error.
struct EnergyAccount {
  double before;                     // at the start, and what a moving floor or racket gave since
  double lost;                       // to the damper; 0 while no book is kept
  std::optional<double> exact = {};  // of the exact solution, now; nothing where there is none
};

/// Where the energy went since a run began, or its parameters changed [J]. Keeping the damper's
/// account costs as much as a step, so that only the window does it.
struct EnergyBook {
  bool is_kept = false;
  double before = 0;  // at the start; and what a moving floor gave since
  double lost = 0;    // to the damper since then; 0 while the book is not kept

  void open(double energy) {
    before = energy;
    lost = 0;
  }
};

/// What a simulation is like, as plain data. Most have the defaults.
struct Traits {
  std::string_view columns;  // of the trace, after `t`, separated by commas
  std::optional<ContactNumbers> contact = {};
  std::size_t balls = 1;       // rows of the trace at one time
  double swing_rate = 0;       // rad/s, of something that swings by itself, such as a floor
  bool cuts_steps = false;     // at contacts that they are too long for: then none is too long
  double pieces_per_step = 1;  // into how many a step may then be cut: what it can cost, in steps
  std::string_view truth = "exact";  // what it is compared with, where there is anything
  std::string refusal = {};          // why the chosen method cannot serve this scene; empty: it can
  std::string summary = {};          // more words for the summary line, "name=value"
  std::string command = {};  // words, besides parameters, of the command that makes such a run
  std::vector<std::pair<std::string, std::string>> saved_options = {};  // StageOption::is_saved
};

/// A scene that runs: the scene's parameters, the state, the method and the clock. Command line,
/// headless run and window know stages through this class only; RunOf (run.hpp) makes one from a
/// world.
class Simulation {
 public:
  virtual ~Simulation() = default;
  virtual std::unique_ptr<Simulation> clone() const = 0;

  // ---- What it is
  virtual std::vector<Parameter> parameters() = 0;  // they refer into this object
  virtual std::vector<Method> methods() const = 0;
  virtual Traits traits() const = 0;
  std::vector<std::string> columns() const { return split(traits().columns); }
  std::optional<ContactNumbers> contact() const { return traits().contact; }
  std::size_t balls() const { return traits().balls; }

  // ---- Where it stands
  double time() const { return clock_.time(); }    // [s]
  double dt() const { return clock_.dt(); }        // [s]
  double tolerance() const { return tolerance_; }  // of `reference`
  std::uint64_t seed() const { return seed_; }     // of what a start has of chance in it
  const Method& method() const { return method_; }
  long long steps() const { return clock_.steps(); }  // since the start, cut ones too

  virtual std::vector<double> values() const = 0;  // one trace row (or more) without `t`
  virtual Energy energy() const = 0;               // [J]
  virtual EnergyAccount energy_account() const = 0;
  /// Force evaluations besides the fixed number a step (Method): where events are located.
  virtual long long counted_force_evaluations() const = 0;

  // ---- Against the exact solution, from the last start or change of parameters on; or nothing
  virtual std::vector<double> exact_values(double /*t*/) const { return {}; }
  virtual std::optional<StateError> error() const { return std::nullopt; }  // now

  // ---- Setting it up. Method and time step may change in the middle of a run.
  void use_method(const Method& method);
  void use_dt(double dt);
  void use_tolerance(double tolerance);
  void use_seed(std::uint64_t seed) { seed_ = seed; }
  void keep_energy_book(bool keep) { book_.is_kept = keep; }
  void restart();  // from t = 0 and the scene's start

  /// Puts the ball somewhere else in the middle of a run: a trace row's values.
  virtual void place(const std::vector<double>& values) = 0;

  /// After a change of parameters in the middle of a run: the method forgets what it carried, and
  /// what is compared (exact solution, energy before) starts anew from here.
  virtual void parameters_changed() = 0;

  // ---- Moving. Throws NonFinite, and leaves the last good state.
  void advance_to(double t);
  /// The same in portions of about a second at most, so that one can be heard in between. Returns
  /// whether it has arrived.
  bool advance_some(double t);
  void advance_one_step() { advance_to(time_of_next_step()); }
  double time_of_next_step() const { return clock_.time_of_next_step(); }

  /// The next touch or lift-off [s], for the methods that go by events; else infinity.
  virtual double next_event() const { return never; }

  // No run that begins with allowed parameters has numbers beyond `valid_number`, unless it
  // explodes; there squares and products overflow, and a step may take for ever.
  static constexpr Range valid_dt{1e-15, 1e15}, valid_tolerance{1e-15, 1}, valid_time{0, 1e15},
      valid_count{0, 1e18}, valid_number{-1e100, 1e100};

  // ---- For `--save` and `--load`: all that the next step depends on, as plain numbers.
  struct Memory : StepClock::Memory {
    double tolerance = 1e-12;
    std::vector<double> numbers = {};  // state and the method's own memory (remembered.hpp)

    /// visit(name, value, valid range) for all but these numbers, also of one that must not change.
    template <class Self, class Visit>
    static void each(Self& self, const Visit& visit) {
      visit("time", self.time, valid_time);
      visit("dt", self.dt, valid_dt);
      visit("tolerance", self.tolerance, valid_tolerance);
      visit("grid_start", self.grid_start, valid_time);
      visit("grid_steps", self.grid_steps, valid_count);
      visit("into_step", self.into_step, Range{0, self.dt});
      visit("steps", self.steps, valid_count);
    }
  };
  Memory memory() const { return {clock_.memory(), tolerance_, numbers()}; }
  void recall(const Memory& memory);  // throws BadInput when it does not fit

 protected:
  explicit Simulation(const Method& method) : method_(method) {}
  Simulation(const Simulation&) = default;
  Simulation& operator=(const Simulation&) = default;

  virtual void reset_state() = 0;      // to the scene's start
  virtual void compare_from_here() {}  // exact solution and energy book start anew
  /// Returns whether the state is still made of finite numbers.
  virtual bool take_steps(long long count, double t, double dt) = 0;
  /// Passes at most so many events. Returns the time that it has reached; throws NonFinite.
  virtual double go_by_events_towards(double t, long long /*most_events*/) { return t; }
  virtual std::vector<double> numbers() const = 0;
  /// Returns what does not fit, or nothing.
  virtual std::string recall_numbers(const std::vector<double>& numbers) = 0;

  EnergyBook book_;

 private:
  void start_grid_here();
  void take_checked_steps(long long count, double t, double dt);

  Method method_;
  double tolerance_ = 1e-12;
  std::uint64_t seed_ = 1;
  StepClock clock_;
};

/// A run under its own type, for whoever made it: a demo's picture and dials. That it is of this
/// type is checked; std::bad_cast tells a demo that was put together from the parts of two.
template <class Its>
const Its& run_as(const Simulation& simulation) {
  return dynamic_cast<const Its&>(simulation);
}
template <class Its>
Its& run_as(Simulation& simulation) {
  return dynamic_cast<Its&>(simulation);
}
/// The same where there may be another one: then nullptr.
template <class Its>
const Its* run_if(const Simulation& simulation) {
  return dynamic_cast<const Its*>(&simulation);
}
template <class Its>
Its* run_if(Simulation& simulation) {
  return dynamic_cast<Its*>(&simulation);
}

}  // namespace bounce

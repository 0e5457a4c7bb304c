#pragma once
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "physics/concepts.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Events follow each other without time going on. It carries the time at which that happened, and
/// what would help.
struct TimeStandsStill : std::runtime_error {
  explicit TimeStandsStill(double t_stuck)
      : TimeStandsStill(t_stuck, "events no longer advance time",
                        "take a stepping method, such as --method semi-implicit-euler") {}
  TimeStandsStill(double t_stuck, const std::string& what_happens, std::string what_helps)
      : std::runtime_error(what_happens), t(t_stuck), advice(std::move(what_helps)) {}
  double t;
  std::string advice;
};

/// A phase that ends at `t` and is no longer than this [s] does not count as time going on.
template <class Phases>
double too_short(const Phases& phases, double t) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * t;
  if constexpr (requires { phases.shortest_phase(); }) {
    return std::max(rounding, phases.shortest_phase());
  }
  return rounding;
}

/// Walks from event to event (touch, lift-off). Within a phase the movement is a formula, so there
/// is no time step, no step error, and the cost is per bounce, whatever the stiffness. What remains
/// is rounding. `Phases` is a type like BouncePhases (closed_form.hpp); `Vector` as in state.hpp.
/// Phases whose law depends on the time (a floor that moves) have a `begin(t)` besides: it is told
/// when each phase begins, and all that is asked afterwards counts from there. They also name a
/// `shortest_phase()`: a thousand shorter ones in a row are no movement that can be followed.
template <class Phases, class Vector = double>
requires PhasesFor<Phases, Vector>
class EventDriven {
 public:
  EventDriven(const Phases& phases, double t, const State<Vector>& state)
      : phases_(phases), start_(t), state_(state) {
    begin_phase();
    phase_ = phases_.phase_at(state);
    find_end();
  }

  /// The state at time `t`. Time only goes forward: `t` may not lie before the last event passed.
  State<Vector> at(double t) {
    while (t >= next_event()) pass_event();
    return phases_.move(phase_, state_, t - start_);
  }

  /// Passes the events up to `t`, but at most so many. Returns whether it got there.
  bool reach(double t, long long most_events) {
    for (; t >= next_event(); --most_events) {
      if (most_events == 0) return false;
      pass_event();
    }
    return true;
  }

  double next_event() const { return start_ + end_.after; }  // [s]; `never` when there is none
  double last_event() const { return start_; }  // [s]; the start before the first event
  Phase phase() const { return phase_; }
  const Phases& phases() const { return phases_; }
  const State<Vector>& state_at_last_event() const { return state_; }

  void pass_event() {
    crowded_ = end_.after > too_short(phases_, start_) ? 0 : crowded_ + 1;
    if (crowded_ > 1000) throw TimeStandsStill(start_);
    const State<Vector> arrived = arrival();
    start_ += end_.after;
    begin_phase();
    state_ = phases_.at_event(phase_, end_.next, arrived);
    phase_ = end_.next;
    find_end();
  }

  /// What is saved of a run: the phase, and when and how it began. After loading it goes on from
  /// there with `resume`.
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit("phase_start", self.start_);
    visit("state_at_phase_start", self.state_);
    visit("phase", self.phase_);
  }
  void resume() {
    begin_phase();
    find_end();
  }

 private:
  void begin_phase() {
    if constexpr (requires { phases_.begin(start_); }) phases_.begin(start_);
  }
  /// Where the current phase ends. Phases that know it from the search for the end have `arrive`.
  State<Vector> arrival() const {
    if constexpr (requires { phases_.arrive(state_, end_); }) {
      return phases_.arrive(state_, end_);
    } else {
      return phases_.move(phase_, state_, end_.after);
    }
  }
  void find_end() { end_ = phases_.end_of(phase_, state_); }

  Phases phases_;
  double start_;  // when the current phase began
  State<Vector> state_;
  Phase phase_{};
  PhaseEnd end_{};
  int crowded_ = 0;  // events in a row that did not advance time
};

}  // namespace bounce

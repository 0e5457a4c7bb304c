#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "physics/events/closed_form.hpp"
#include "physics/events/cubic.hpp"
#include "physics/events/event_driven.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Steps that are cut exactly where the law of motion changes: at a touch, and where a contact
/// ends. Within a piece the law is smooth, so that a stepping method keeps its order across
/// bounces; without the cuts every method falls to order 1 at a damped touch.
///
/// For `Phases` see concepts.hpp. The end of a flight is known by formula, or by exact's search.
template <class Phases, class Vector>
class LocatedEvents {
 public:
  LocatedEvents(const Phases& phases, double t,
                const State<Vector>& state) requires LocatedPhasesFor<Phases, Vector>
      : phases_(phases), start_(t), at_start_(state) {
    begin_at(t);
    phase_ = phases_.phase_at(state);
    find_end();
  }

  /// One step from `t` to `end` in as many pieces as there are phases in it. `step(law, t, state,
  /// dt)` is a stepping method that carries nothing from step to step. Steps are
  /// given by both their ends, because the next one must begin exactly where this one ended: tiny
  /// gaps between 1e5 steps would add up.
  template <class Step>
  void operator()(const Step& step, double t, State<Vector>& state, double end) {
    while (take_piece(step, t, state, end)) {
    }
  }

  /// The same, but flights are not stepped at all: the parabola is known.
  template <class Step>
  void with_flights_by_formula(const Step& step, double t, State<Vector>& state, double end) {
    while (true) {
      if (phase_ == Phase::touch) {
        if (!take_piece(step, t, state, end)) return;
      } else if (next_event() > end) {
        state = phases_.move(phase_, at_start_, end - start_);
        return;
      } else {
        t = next_event();
        state = phases_.move(phase_, at_start_, end_.after);
        pass_event(t, state, end_.next);
      }
    }
  }

  /// How many steps of `dt` from `t` on lie in the current flight, and need not be taken.
  long long steps_in_flight(double t, double dt, long long most) const {
    if (phase_ == Phase::touch) return 0;
    const double steps = std::floor((next_event() - t) / dt) - 1;
    return steps < static_cast<double>(most) ? std::max(0LL, static_cast<long long>(steps)) : most;
  }

  /// When the current flight ends [s]; before that time for a touch, whose end is yet to be found.
  double next_event() const { return start_ + end_.after; }

  long long force_evaluations() const { return law_.evaluations; }

  Phase phase() const { return phase_; }
  double phase_start() const { return start_; }  // [s]

  /// What is saved of a run: the phase, and when and how it began. After loading it goes on from
  /// there with `resume`.
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit("phase_start", self.start_);
    visit("state_at_phase_start", self.at_start_);
    visit("phase", self.phase_);
  }
  void resume() {
    begin_at(start_);
    find_end();
  }

 private:
  // The law of one phase, in the form that a stepping method asks for.
  struct Law {
    Vector acceleration(double t, const State<Vector>& state) const {
      ++evaluations;
      return phases->acceleration(phase, t - start, state);
    }
    const Phases* phases;
    Phase phase;
    double start;  // of the phase [s]
    mutable long long evaluations;
  };

  // What a touch can give way to. It lasts while a function of time is positive, whose second
  // derivative stays below a bound until then.
  struct WatchedEvent {
    Phase next;
    double max_bend;
    RootInStep root;
  };

  /// Goes on to `end`, or to the next event before it; then it says true.
  template <class Step>
  bool take_piece(const Step& step, double& t, State<Vector>& state, double end) {
    law_.phases = &phases_;  // this object may have been copied
    law_.phase = phase_;
    law_.start = start_;
    if (phase_ == Phase::touch) return touch_until(step, t, state, end);
    if (next_event() > end) {
      step(law_, t, state, end - t);
      return false;
    }
    step(law_, t, state, next_event() - t);
    t = next_event();
    pass_event(t, state, end_.next);
    return true;
  }

  template <class Step>
  bool touch_until(const Step& step, double& t, State<Vector>& state, double end) {
    double dt = end - t;
    int tiny_steps = 0;
    while (t < end) {
      State<Vector> after = state;
      step(law_, t, after, dt);
      const bool tiny = dt < 4 * std::numeric_limits<double>::epsilon() * end;
      bool is_certain = true;
      std::optional<Phase> next;
      for (WatchedEvent& watched : watched_) {
        watched.root = root_in_step(watched, t, state, after, dt, tiny);
        is_certain = is_certain && watched.root != RootInStep::unclear;
        if (watched.root == RootInStep::one) next = watched.next;
      }
      if (!is_certain && !tiny) {  // a smaller step tells more
        dt /= 2;
        continue;
      }
      if (next) {
        t += cut_at_first_end(step, t, state, dt, *next);
        pass_event(t, state, *next);
        return true;
      }
      // No number, or far too large ones?
      if (!is_certain && ++tiny_steps > 1000) throw TimeStandsStill(t);
      state = after;
      t = dt == end - t ? end : t + dt;
      dt = end - t;
    }
    return false;
  }

  RootInStep root_in_step(const WatchedEvent& watched, double t, const State<Vector>& state,
                          const State<Vector>& after, double dt, bool tiny) const {
    const double since = t - start_;
    const EventValue before = phases_.event_value(watched.next, since, state);
    const EventValue now = phases_.event_value(watched.next, since + dt, after);
    // The bound of the touch's start serves most steps. That of the present moment is far below it
    // once the ball has come to rest, and lets it rest in whole steps.
    double max_bend = watched.max_bend;
    if (stays_positive(before, now, dt, max_bend)) return RootInStep::none;
    max_bend = std::min(max_bend, phases_.max_bend(watched.next, since, state, dt));
    if (stays_positive(before, now, dt, max_bend)) return RootInStep::none;
    // Where the function falls all the way, it has one zero.
    const bool falls = now.slope < -max_bend * dt;
    return now.value <= 0 && (falls || tiny) ? RootInStep::one : RootInStep::unclear;
  }

  /// Where several things end the touch within a step of `dt`, the first of them does: `next`.
  template <class Step>
  double cut_at_first_end(const Step& step, double t, State<Vector>& state, double dt,
                          Phase& next) {
    const State<Vector> before = state;
    double first = never;
    for (const WatchedEvent& watched : watched_) {
      if (watched.root != RootInStep::one) continue;
      State<Vector> after = before;
      const double length = cut(step, t, after, dt, watched.next);
      if (!(length < first)) continue;
      first = length;
      next = watched.next;
      state = after;
    }
    return first;
  }

  /// Shortens a step of `dt`, over which the touch ends, until it ends there: Newton's method on
  /// the step's length. Moves the state and returns that length.
  template <class Step>
  double cut(const Step& step, double t, State<Vector>& state, double dt, Phase next) {
    double low = 0, high = dt, length = dt;
    State<Vector> after = state;
    for (int i = 0; i < 60; ++i) {
      after = state;
      step(law_, t, after, length);
      const EventValue now = phases_.event_value(next, t - start_ + length, after);
      (now.value > 0 ? low : high) = length;
      double better = length - now.value / now.slope;
      if (!(low <= better && better <= high)) better = (low + high) / 2;
      if (std::abs(better - length) <= std::numeric_limits<double>::epsilon() * (t + dt)) break;
      length = better;
    }
    state = after;
    return length;
  }

  void pass_event(double t, State<Vector>& state, Phase next) {
    crowded_ = t - start_ > too_short(phases_, t) ? 0 : crowded_ + 1;
    if (crowded_ > 1000) throw TimeStandsStill(t);
    begin_at(t);
    state = phases_.at_event(phase_, next, state);
    begin_phase(state, next);
  }

  void begin_at(double t) {
    start_ = t;
    if constexpr (requires { phases_.begin(t); }) phases_.begin(t);
  }
  void begin_phase(const State<Vector>& state, Phase phase) {
    at_start_ = state;
    phase_ = phase;
    find_end();
  }
  void find_end() {
    if (phase_ != Phase::touch) {
      end_ = phases_.end_of(phase_, at_start_);
      return;
    }
    end_ = {0, phase_};
    watched_.clear();
    for (const Phase next : phases_.after_touch()) {
      watched_.push_back({next, phases_.max_bend(next, 0, at_start_, never), RootInStep::none});
    }
  }

  Phases phases_;
  double start_;  // when the current phase began
  State<Vector> at_start_;
  Phase phase_{};
  PhaseEnd end_{};
  std::vector<WatchedEvent> watched_;  // in a touch
  int crowded_ = 0;                    // events in a row that did not advance time
  Law law_{&phases_, phase_, 0, 0};
};

}  // namespace bounce

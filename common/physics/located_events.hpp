#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/closed_form.hpp"
#include "physics/event_driven.hpp"
#include "physics/state.hpp"

namespace bounce {

/// Steps that are cut exactly where the law of motion changes: at a touch, and where a contact
/// ends. Within a piece the law is smooth, so that a stepping method keeps its order across
/// bounces; without the cuts every method falls to order 1 at a damped touch.
///
/// `Phases` is a type like BouncePhases (closed_form.hpp) which also tells, for each phase, a law
///   Vector acceleration(Phase, const State<Vector>&)
/// that is smooth across the phase's end, and, for a touch, the function whose sign tells that it
/// lasts (`Lasting`). A flight is a parabola, and its end is known by formula.
template <class Phases, class Vector>
class LocatedEvents {
 public:
  LocatedEvents(const Phases& phases, double t, const State<Vector>& state)
      : phases_(phases), start_(t), at_start_(state), phase_(phases_.phase_at(state)) {
    begin_phase();
  }

  /// One step from `t` to `end` in as many pieces as there are phases in it. `step(law, t, state,
  /// dt)` is a stepping method (integrators.hpp) that carries nothing from step to step. Steps are
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

  // For saving and loading: the phase, and when and how it began.
  Phase phase() const { return phase_; }
  double phase_start() const { return start_; }
  const State<Vector>& state_at_phase_start() const { return at_start_; }
  void resume(double t, const State<Vector>& state, Phase phase) {
    start_ = t;
    at_start_ = state;
    phase_ = phase;
    begin_phase();
  }

 private:
  // The law of one phase, in the form that a stepping method asks for.
  struct Law {
    Vector acceleration(double /*t*/, const State<Vector>& state) const {
      ++evaluations;
      return phases->acceleration(phase, state);
    }
    const Phases* phases;
    Phase phase;
    mutable long long evaluations;
  };

  /// Goes on to `end`, or to the next event before it; then it says true.
  template <class Step>
  bool take_piece(const Step& step, double& t, State<Vector>& state, double end) {
    law_.phases = &phases_;  // this object may have been copied
    law_.phase = phase_;
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
      const Lasting before = phases_.touch_lasts(state);
      State<Vector> after = state;
      step(law_, t, after, dt);
      // The bound of the touch's start serves most steps. That of the present moment is far below
      // it once the ball has come to rest, and lets it rest in whole steps.
      double max_bend = max_bend_;
      bool is_certain = certain_to_last(before, after, dt, max_bend);
      if (!is_certain) {
        max_bend = std::min(max_bend, phases_.max_bend(state));
        is_certain = certain_to_last(before, after, dt, max_bend);
      }
      if (!is_certain) {
        const Lasting now = phases_.touch_lasts(after);
        // Where the function falls all the way, it has one zero. Else a smaller step tells more.
        const bool falls = now.slope < -max_bend * dt;
        const bool tiny = dt < 4 * std::numeric_limits<double>::epsilon() * end;
        if (now.value <= 0 && (falls || tiny)) {
          t += cut(step, t, state, dt);
          pass_event(t, state, phases_.after_touch());
          return true;
        }
        if (!tiny) {
          dt /= 2;
          continue;
        }
        if (++tiny_steps > 1000) throw TimeStandsStill(t);  // no number, or far too large ones
      }
      state = after;
      t = dt == end - t ? end : t + dt;
      dt = end - t;
    }
    return false;
  }

  /// With |f''| <= B (`max_bend`), f stays above its parabola value + slope s - B s^2 / 2, which is
  /// positive between two moments at which it is; and f stays above its chord minus B dt^2 / 8.
  bool certain_to_last(const Lasting& before, const State<Vector>& after, double dt,
                       double max_bend) const {
    if (before.value + (before.slope - max_bend * dt / 2) * dt > 0) return true;
    const double chord = std::min(before.value, phases_.touch_lasts(after).value);
    return chord > max_bend * dt * dt / 8;
  }

  /// Shortens a step of `dt`, over which the touch ends, until it ends there: Newton's method on
  /// the step's length. Moves the state and returns that length.
  template <class Step>
  double cut(const Step& step, double t, State<Vector>& state, double dt) {
    double low = 0, high = dt, length = dt;
    State<Vector> after = state;
    for (int i = 0; i < 60; ++i) {
      after = state;
      step(law_, t, after, length);
      const Lasting now = phases_.touch_lasts(after);
      (now.value > 0 ? low : high) = length;
      double next = length - now.value / now.slope;
      if (!(low <= next && next <= high)) next = (low + high) / 2;
      if (std::abs(next - length) <= std::numeric_limits<double>::epsilon() * (t + dt)) break;
      length = next;
    }
    state = after;
    return length;
  }

  void pass_event(double t, State<Vector>& state, Phase next) {
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * t;
    crowded_ = t - start_ > rounding ? 0 : crowded_ + 1;
    if (crowded_ > 1000) throw TimeStandsStill(t);
    state = phases_.at_event(phase_, next, state);
    resume(t, state, next);
  }

  void begin_phase() {
    if (phase_ == Phase::touch) {
      end_ = {0, phase_};
      max_bend_ = phases_.max_bend(at_start_);
    } else {
      end_ = phases_.end_of(phase_, at_start_);
    }
  }

  Phases phases_;
  double start_;  // when the current phase began
  State<Vector> at_start_;
  Phase phase_;
  PhaseEnd end_{};
  double max_bend_ = 0;  // bounds the second derivative of what tells that a touch lasts
  int crowded_ = 0;      // events in a row that did not advance time
  Law law_{&phases_, phase_, 0};
};

}  // namespace bounce

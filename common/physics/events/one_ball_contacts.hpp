#pragma once
#include "physics/events/closed_form.hpp"
#include "physics/state.hpp"

namespace bounce {

/// The contacts of a scene with one ball, in the form that `Reference` (reference_walk.hpp) asks
/// for. `Phases` is a type like BouncePhases (closed_form.hpp); of a touch only its law is used.
template <class Phases, class Vector>
class OneBallContacts {
 public:
  using Event = Phase;  // what can come after a touch

  OneBallContacts(const Phases& phases, double t, const State<Vector>& state) : phases_(phases) {
    begin(t);
    phase_ = phases_.phase_at(state);
  }

  Phase phase() const { return phase_; }

  void begin(double t) {
    if constexpr (requires { phases_.begin(t); }) phases_.begin(t);
  }
  double shortest_phase() const {
    if constexpr (requires { phases_.shortest_phase(); }) return phases_.shortest_phase();
    return 0;
  }

  bool in_flight() const { return phase_ != Phase::touch; }
  double flight_time(double /*t*/, const State<Vector>& state) {
    end_ = phases_.end_of(phase_, state);
    return end_.after;
  }
  State<Vector> fly(const State<Vector>& state, double t) const {
    return phases_.move(phase_, state, t);
  }
  void land(double t, State<Vector>& state) { pass(end_.next, t, state); }

  Vector acceleration(double t, const State<Vector>& state) const {
    return phases_.acceleration(Phase::touch, t, state);
  }
  auto events(const State<Vector>&, double) const { return phases_.after_touch(); }
  EventValue event_value(Event next, double t, const State<Vector>& state, const Vector&) const {
    return phases_.event_value(next, t, state);
  }
  double rounding(Event, const State<Vector>&) const { return 0; }
  bool resolves(const State<Vector>&, const State<Vector>&, double) const { return true; }
  void pass(Event next, double t, State<Vector>& state) {
    begin(t);
    state = phases_.at_event(phase_, next, state);
    phase_ = next;
  }
  double time_scale() const { return phases_.time_scale(); }

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit("phase", self.phase_);
  }

 private:
  Phases phases_;
  Phase phase_{};
  PhaseEnd end_{};
};

}  // namespace bounce

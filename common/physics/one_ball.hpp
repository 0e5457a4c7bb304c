#pragma once
#include <array>

#include "physics/closed_form.hpp"
#include "physics/state.hpp"

namespace bounce {

/// The contacts of a scene with one ball, in the form that `Reference` (reference.hpp) asks for.
/// `Phases` is a type like BouncePhases (closed_form.hpp); of a touch only its law is used.
template <class Phases, class Vector>
class OneBall {
 public:
  struct Watch {};  // one thing can happen: the touch ends

  OneBall(const Phases& phases, Phase phase) : phases_(phases), phase_(phase) {}
  OneBall(const Phases& phases, const State<Vector>& state)
      : OneBall(phases, Phases(phases).phase_at(state)) {}

  Phase phase() const { return phase_; }

  bool in_flight() const { return phase_ != Phase::touch; }
  double flight_time(double /*t*/, const State<Vector>& state) {
    end_ = phases_.end_of(phase_, state);
    return end_.after;
  }
  State<Vector> fly(const State<Vector>& state, double t) const {
    return phases_.move(phase_, state, t);
  }
  void land(double /*t*/, State<Vector>& state) { change_to(end_.next, state); }

  Vector acceleration(double /*t*/, const State<Vector>& state) const {
    return phases_.acceleration(Phase::touch, state);
  }
  std::array<Watch, 1> watches(const State<Vector>&, double) const { return {}; }
  Lasting lasts(Watch, double /*t*/, const State<Vector>& state, const Vector&) const {
    return phases_.touch_lasts(state);
  }
  double rounding(Watch, const State<Vector>&) const { return 0; }
  bool resolves(const State<Vector>&, const State<Vector>&, double) const { return true; }
  void pass(Watch, double /*t*/, State<Vector>& state) { change_to(phases_.after_touch(), state); }
  double time_scale() const { return phases_.time_scale(); }

 private:
  void change_to(Phase next, State<Vector>& state) {
    state = phases_.at_event(phase_, next, state);
    phase_ = next;
  }

  Phases phases_;
  Phase phase_;
  PhaseEnd end_{};
};

}  // namespace bounce

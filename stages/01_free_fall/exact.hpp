#pragma once
#include "01_free_fall/free_fall.hpp"
#include "physics/events/closed_form.hpp"

namespace bounce {

/// Stage 1 in closed form: one parabola, from the start to for ever.
struct FreeFallExact {
  explicit FreeFallExact(const FreeFall& scene) : gravity(scene.gravity) {}

  Phase phase_at(const State<double>& /*state*/) const { return Phase::flight; }
  State<double> move(Phase /*phase*/, const State<double>& start, double t) const {
    return fly(start, gravity, t);
  }
  PhaseEnd end_of(Phase phase, const State<double>& /*start*/) const { return {never, phase}; }
  State<double> at_event(Phase /*before*/, Phase /*after*/, State<double> state) const {
    return state;
  }

  double gravity;  // m/s^2
};

}  // namespace bounce

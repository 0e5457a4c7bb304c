#pragma once
#include "physics/methods/rk4_events.hpp"

namespace bounce {

namespace methods {
inline constexpr Method flight_rk4{
    .name = "flight-rk4",
    .about = "flights by formula, contacts by rk4 with its steps cut at their ends",
    .order = 4,
    .evaluations = 0,
    .mark = Mark::triangle_down,
    .stability_limit = rk4_limit};
}  // namespace methods

/// As Rk4Events in contact; flights are not stepped at all, since their parabola is known.
template <class Phases, class Vector>
struct FlightRk4 : Rk4Events<Phases, Vector> {
  static constexpr Method facts = methods::flight_rk4;
  using Rk4Events<Phases, Vector>::Rk4Events;

  void step_to(double end, double t, State<Vector>& state) {
    this->located.with_flights_by_formula(this->rk4_step, t, state, end);
  }
  /// How many steps from `t` on need not be taken: they lie in the current flight.
  long long steps_to_skip(double t, double dt, long long most) const {
    return this->located.steps_in_flight(t, dt, most);
  }
};

}  // namespace bounce

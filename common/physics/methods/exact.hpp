#pragma once
#include "physics/events/event_driven.hpp"
#include "physics/methods/event_method.hpp"
#include "physics/methods/method.hpp"

namespace bounce {

namespace methods {
inline constexpr Method exact{
    .name = "exact",
    .about = "no steps: from event to event by formula, with rounding error only",
    .order = 0,
    .evaluations = 0,
    .goes_by_events = true};
}  // namespace methods

/// Where flight and contact have closed forms. `Phases` are those of the scene
/// (events/closed_form.hpp).
template <class Phases, class Vector>
struct ExactMethod : EventMethod<EventDriven<Phases, Vector>> {
  static constexpr Method facts = methods::exact;

  template <class World>
  ExactMethod(const World& world, double t, const State<Vector>& state, double /*tolerance*/)
      : EventMethod<EventDriven<Phases, Vector>>{{world.phases(), t, state}} {}

  /// A start on the touch begins with it.
  void pass_event_at(double t) { this->walk.reach(t, 1); }
};

}  // namespace bounce

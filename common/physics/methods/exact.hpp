#pragma once
#include "physics/events/event_driven.hpp"
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
struct ExactMethod {
  static constexpr Method facts = methods::exact;

  template <class World>
  ExactMethod(const World& world, double t, const State<Vector>& state, double /*tolerance*/)
      : walk(world.phases(), t, state) {}

  /// A start on the touch begins with it.
  void pass_event_at(double t) { walk.reach(t, 1); }

  double go_towards(double t, long long most_events, State<Vector>& state) {
    const double reached = walk.reach(t, most_events) ? t : walk.last_event();
    state = walk.at(reached);
    return reached;
  }
  double next_event() const { return walk.next_event(); }

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    self.walk.remembered(self.walk, visit);
  }
  void resume() { walk.resume(); }

  EventDriven<Phases, Vector> walk;
};

}  // namespace bounce

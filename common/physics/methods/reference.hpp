#pragma once
#include "physics/events/reference_walk.hpp"
#include "physics/methods/method.hpp"

namespace bounce {

namespace methods {
inline constexpr Method reference{
    .name = "reference",
    .about = "flights by formula, contacts by DOP853 within --tolerance, events located",
    .order = 8,
    .evaluations = 0,
    .goes_by_events = true};
}  // namespace methods

/// What stands for `exact` where a contact has no closed form. `Contacts` are those of the scene
/// (concepts.hpp).
template <class Contacts, class Vector>
struct ReferenceMethod {
  static constexpr Method facts = methods::reference;

  template <class World>
  ReferenceMethod(const World& world, double t, const State<Vector>& state, double tolerance)
      : walk(world.contacts(t, state), t, state, tolerance) {}

  double go_towards(double t, long long most_events, State<Vector>& state) {
    const double reached = walk.reach(t, most_events) ? t : walk.last_event();
    state = walk.at(reached);
    return reached;
  }
  double next_event() const { return walk.next_event(); }
  long long counted_evaluations() const { return walk.force_evaluations(); }

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    self.walk.remembered(self.walk, visit);
  }
  void resume() { walk.resume(); }

  Reference<Contacts, Vector> walk;
};

}  // namespace bounce

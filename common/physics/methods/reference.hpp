#pragma once
#include "physics/events/reference_walk.hpp"
#include "physics/methods/event_method.hpp"
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
struct ReferenceMethod : EventMethod<Reference<Contacts, Vector>> {
  static constexpr Method facts = methods::reference;

  template <class World>
  ReferenceMethod(const World& world, double t, const State<Vector>& state, double tolerance)
      : EventMethod<Reference<Contacts, Vector>>{{world.contacts(t, state), t, state, tolerance}} {}

  long long counted_evaluations() const { return this->walk.force_evaluations(); }
};

}  // namespace bounce

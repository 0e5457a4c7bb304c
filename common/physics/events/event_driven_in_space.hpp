#pragma once
#include <Eigen/Core>
#include <type_traits>
#include <utility>

#include "physics/events/event_driven.hpp"

namespace bounce {

/// From event to event in space, for a ball whose contact pushes along one direction that never
/// turns (stages 4 and 7). No force mixes that direction with the others, so the events are those
/// of a ball in one dimension, and beside it one formula holds from the start of the run to its
/// end: no event rounds the place, however far from the origin it is. `Phases` say how to split a
/// state, and how to put it together:
/// * bounce(): the phases along the contact's direction, as in closed_form.hpp;
/// * along(state): the part of a state in that direction, a State<double>;
/// * beside(state): the rest of it, a State<Vector3d>;
/// * move_beside(rest, t): that rest `t` seconds later;
/// * together(rest, along): the whole state again.
template <class Phases>
requires requires(const Phases& phases) { phases.bounce(); }
class EventDriven<Phases, Eigen::Vector3d> {
  using InSpace = State<Eigen::Vector3d>;
  using AlongNormal = State<double>;

 public:
  EventDriven(const Phases& phases, double t, const InSpace& state)
      : phases_(phases),
        bounce_(phases.bounce(), t, phases.along(state)),
        start_(t),
        beside_(phases.beside(state)) {}

  // What these mean is said at EventDriven.
  InSpace at(double t) { return together(bounce_.at(t), t); }
  bool reach(double t, long long most_events) { return bounce_.reach(t, most_events); }
  void pass_event() { bounce_.pass_event(); }
  double next_event() const { return bounce_.next_event(); }
  double last_event() const { return bounce_.last_event(); }
  Phase phase() const { return bounce_.phase(); }
  InSpace state_at_last_event() const {
    return together(bounce_.state_at_last_event(), last_event());
  }

  // A run that is saved keeps both parts, unrounded.
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit("start", self.start_);
    visit("beside_at_start", self.beside_);
    self.bounce_.remembered(self.bounce_, visit);
  }
  void resume() { bounce_.resume(); }

 private:
  InSpace together(const AlongNormal& along, double t) const {
    return phases_.together(phases_.move_beside(beside_, t - start_), along);
  }

  Phases phases_;
  EventDriven<std::remove_cvref_t<decltype(std::declval<Phases>().bounce())>> bounce_;
  double start_;
  InSpace beside_;
};

}  // namespace bounce

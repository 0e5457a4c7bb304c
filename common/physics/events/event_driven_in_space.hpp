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

/// The same phases for methods that step, but locate events or fly by formula. What `Self` says of
/// them is split as above, and put together again.
template <class Self>
class PhasesInSpace {
  using Ball = State<Eigen::Vector3d>;

 public:
  Phase phase_at(const Ball& ball) const { return bounce().phase_at(self().along(ball)); }
  Ball move(Phase phase, const Ball& start, double t) const {
    return self().together(self().move_beside(self().beside(start), t),
                           bounce().move(phase, self().along(start), t));
  }
  PhaseEnd end_of(Phase phase, const Ball& start) const {
    return bounce().end_of(phase, self().along(start));
  }
  Ball at_event(Phase before, Phase after, const Ball& ball) const {
    return self().together(self().beside(ball),
                           bounce().at_event(before, after, self().along(ball)));
  }
  EventValue event_value(Phase next, double t, const Ball& ball) const {
    return bounce().event_value(next, t, self().along(ball));
  }
  auto after_touch() const { return bounce().after_touch(); }
  double time_scale() const { return bounce().time_scale(); }
  double max_bend(Phase next, double t, const Ball& ball, double window) const {
    return bounce().max_bend(next, t, self().along(ball), window);
  }

 private:
  const Self& self() const { return static_cast<const Self&>(*this); }
  decltype(auto) bounce() const { return self().bounce(); }
};

}  // namespace bounce

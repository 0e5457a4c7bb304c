#pragma once
#include <concepts>
#include <ranges>
#include <vector>

#include "physics/energy.hpp"
#include "physics/events/closed_form.hpp"
#include "physics/events/event_value.hpp"
#include "physics/parameters.hpp"
#include "physics/state.hpp"

namespace bounce {

// What the parts of a run must offer. The compiler checks it where a part is handed over, and names
// what is missing there, and not deep inside.

/// A scene tells the force: `acceleration(t, state)` [m/s^2], the energy [J] of a state (with the
/// time, where a floor moves), and its parameters. An acceleration of many balls may be a reference
/// to a matrix that the scene keeps.
template <class Scene, class Vector>
concept SceneFor = requires(const Scene& scene, Scene& own, double t, const State<Vector>& state,
                            Vector& kept) {
  kept = scene.acceleration(t, state);
  { own.parameters() } -> std::same_as<std::vector<Parameter>>;
  requires requires {
    { scene.energy(t, state) } -> std::same_as<Energy>;
  } || requires {
    { scene.energy(state) } -> std::same_as<Energy>;
  };
};

/// The movement of one ball in closed form, phase by phase:
///   Phase phase_at(state)                   in which it begins
///   State move(phase, start, t)             `t` seconds after the phase's start
///   PhaseEnd end_of(phase, start)           after how long it ends, and what comes next
///   State at_event(before, after, state)    what is known exactly at the change from one to the
///                                           other (the height, at a touch)
/// Optional: begin(t), where the law depends on the time: a phase begins, and the times that follow
/// count from it; arrive(start, end), the state at that end without computing it a second time; and
/// shortest_phase(), see too_short() in event_driven.hpp.
template <class Phases, class Vector>
concept PhasesFor = std::copy_constructible<Phases> &&
    requires(Phases& phases, Phase phase, double t, const State<Vector>& state) {
  { phases.phase_at(state) } -> std::same_as<Phase>;
  { phases.move(phase, state, t) } -> std::same_as<State<Vector>>;
  { phases.end_of(phase, state) } -> std::same_as<PhaseEnd>;
  { phases.at_event(phase, phase, state) } -> std::same_as<State<Vector>>;
};

/// Phases that also tell what a method needs that steps through touches, and is cut at their ends:
///   Vector acceleration(phase, t, state)       the phase's law, smooth across its end [m/s^2]
///   after_touch()                              the phases that can come after a touch
///   EventValue event_value(next, t, state)     positive until a touch gives way to `next`
///   double max_bend(next, t, state, window)    a bound on that value's second derivative for so
///                                              many seconds
///   double time_scale()                        of the fastest that happens in a touch [s]
/// Times count from the phase's start.
template <class Phases, class Vector>
concept LocatedPhasesFor = PhasesFor<Phases, Vector> &&
    requires(const Phases& phases, Phase phase, double t, const State<Vector>& state) {
  { phases.acceleration(phase, t, state) } -> std::convertible_to<Vector>;
  requires std::same_as<std::ranges::range_value_t<decltype(phases.after_touch())>, Phase>;
  { phases.event_value(phase, t, state) } -> std::same_as<EventValue>;
  { phases.max_bend(phase, t, state, t) } -> std::same_as<double>;
  { phases.time_scale() } -> std::same_as<double>;
};

/// What touches, and how, for Reference (reference_walk.hpp):
///   bool in_flight()                        nothing acts that the flight's formula does not know
///   double flight_time(t, state)            until a flight ends [s], or `never`
///   State fly(state, s)                     `s` seconds later
///   void land(t, state)                     passes the end of that flight
///   Vector acceleration(s, state)           `s` after a piece began: the law of the contacts that
///                                           are now, smooth across their ends [m/s^2]
///   events(state, h)                        what can happen within `h` seconds: a list of `Event`
///   EventValue event_value(event, s, state, acceleration)   positive until that happens
///   double rounding(event, state)           by how much that value may be off
///   bool resolves(before, after, h)         a step is short enough that this list is complete, and
///                                           that nothing begins and ends within it
///   void pass(event, t, state)              it happens
///   double time_scale()                     of the fastest contact [s]: for the first step
/// Optional: begin(t), where the law knows the time: a piece begins; shortest_phase(), see
/// too_short(); jumps_without_event, if the law may; is_crowd and top_rate(), see contact_step.hpp.
template <class Contacts, class Vector>
concept ContactsFor = std::copy_constructible<Contacts> &&
    requires(Contacts& contacts, const typename Contacts::Event& event, double t,
             const State<Vector>& state, State<Vector>& changed, const Vector& acceleration) {
  { contacts.in_flight() } -> std::same_as<bool>;
  { contacts.flight_time(t, state) } -> std::same_as<double>;
  { contacts.fly(state, t) } -> std::same_as<State<Vector>>;
  contacts.land(t, changed);
  { contacts.acceleration(t, state) } -> std::convertible_to<Vector>;
  requires std::same_as < std::ranges::range_value_t<decltype(contacts.events(state, t))>,
  typename Contacts::Event > ;
  { contacts.event_value(event, t, state, acceleration) } -> std::same_as<EventValue>;
  { contacts.rounding(event, state) } -> std::same_as<double>;
  { contacts.resolves(state, state, t) } -> std::same_as<bool>;
  contacts.pass(event, t, changed);
  { contacts.time_scale() } -> std::same_as<double>;
};

}  // namespace bounce

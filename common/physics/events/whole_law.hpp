#pragma once
#include <array>

#include "physics/events/event_driven.hpp"
#include "physics/events/event_value.hpp"
#include "physics/state.hpp"

namespace bounce {

/// A scene without closed forms, in the form that `Reference` (reference_walk.hpp) asks for: one
/// contact that never ends. Its law is all that the scene says. Nobody tells where that law jumps
/// (at a touch with a damper, say), so no step is cut there. The control of the error finds the
/// jump: its steps become shorter until one across it is good enough. That is less exact than an
/// event: the bounces of stage 3 come out within 1e-6 m after 10 s, not within 1e-12.
template <class Scene, class Vector>
class WholeLaw {
 public:
  struct Event {};  // there is none
  static constexpr bool jumps_without_event = true;

  WholeLaw(const Scene& scene, double t) : scene_(scene), start_(t) {}

  void begin(double t) { start_ = t; }  // a step
  bool in_flight() const { return false; }
  double flight_time(double, const State<Vector>&) const { return never; }
  State<Vector> fly(const State<Vector>& state, double) const { return state; }
  void land(double, State<Vector>&) const {}

  Vector acceleration(double t, const State<Vector>& state) const {
    return scene_.acceleration(start_ + t, state);
  }
  std::array<Event, 0> events(const State<Vector>&, double) const { return {}; }
  EventValue event_value(Event, double, const State<Vector>&, const Vector&) const { return {}; }
  double rounding(Event, const State<Vector>&) const { return 0; }
  /// A longer step might miss a short force between the moments at which it asks.
  bool resolves(const State<Vector>&, const State<Vector>&, double h) const { return h <= 0.02; }
  void pass(Event, double, State<Vector>&) const {}
  double time_scale() const { return 1e-3; }  // s; the control of the error corrects it at once

  template <class Self, class Visit>
  static void remembered(Self&, Visit&) {}

 private:
  Scene scene_;
  double start_;  // of the step [s]
};

}  // namespace bounce

#pragma once
#include "physics/events/located_events.hpp"
#include "physics/methods/rk4.hpp"

namespace bounce {

namespace methods {
inline constexpr Method rk4_events{
    .name = "rk4-events",
    .about = "rk4, with each step cut where a contact begins or ends",
    .order = 4,
    .evaluations = 0,
    .mark = Mark::open_diamond,
    .stability_limit = rk4_limit};
}  // namespace methods

/// rk4 with steps that are cut at the events (located_events.hpp), so that its order holds across
/// bounces. `Phases` are those of the scene.
template <class Phases, class Vector>
struct Rk4Events {
  static constexpr Method facts = methods::rk4_events;

  template <class World>
  Rk4Events(const World& world, double t, const State<Vector>& state, double /*tolerance*/)
      : located(world.phases(), t, state) {}

  /// A step is given by both its ends: the next one must begin exactly where this one ended.
  void step_to(double end, double t, State<Vector>& state) { located(rk4_step, t, state, end); }

  long long counted_evaluations() const { return located.force_evaluations(); }

  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    self.located.remembered(self.located, visit);
  }
  void resume() { located.resume(); }

  static constexpr auto rk4_step = [](const auto& law, double t, State<Vector>& x, double dt) {
    rk4(law, t, x, dt);
  };
  LocatedEvents<Phases, Vector> located;
};

}  // namespace bounce

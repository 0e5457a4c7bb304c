// Your turn: a better loop. Edit mine_method.hpp (./course check loop makes it): fill the gap
// marked YOUR TURN. Then run ./course check loop, or once ./course check loop --watch. The lesson:
// docs/deeper/02_spring_floor.md, "A better loop". Stuck? ./course check loop --hint

#pragma once
#include <optional>

#include "physics/state.hpp"

namespace bounce {

/// A method of your own: it moves any scene, in steps of dt. `Vector` is what a position is: a
/// number, a vector, or a matrix with a column for each ball.
template <class Vector>
struct MyMethod {
  // What it may remember from one step to the next [m/s^2]: empty before the first step. Most
  // methods remember nothing, and leave this as it is.
  std::optional<Vector> acceleration;

  // [step]
  // YOUR TURN: one step, from the time t to t + dt. (Lesson: "A better loop")
  // You have: state.position [m], state.velocity [m/s], t [s], dt [s], and the acceleration at any
  // moment that you ask about, scene.acceleration(time, State<Vector>{position, velocity}) [m/s^2].
  // Must hold: afterwards `state` is one step later, and better than by the loop of stage 1.
  // - In free fall it is where the formula says, to rounding, whatever dt is.
  // - It is at least of order 2: with half of the dt, a quarter of the error or less. The force may
  //   depend on the place and on the time.
  // - On a spring floor without a damper the ball still bounces after 10 000 bounces.
  // - It asks for the acceleration at most 8 times a step.
  // Keep accelerations and velocities in a `Vector`, never in `auto`: what a vector's formula says
  // is computed only when it gets a place of its own.
  template <class Scene>
  void operator()([[maybe_unused]] const Scene& scene, [[maybe_unused]] double t,
                  [[maybe_unused]] State<Vector>& state, [[maybe_unused]] double dt) {
    // <- here
  }
  // [step]

  /// So that a run that was saved goes on as if nothing had been: what is remembered, with a name.
  template <class Self, class Visit>
  static void remembered(Self& self, Visit& visit) {
    visit("acceleration", self.acceleration);
  }
};

}  // namespace bounce

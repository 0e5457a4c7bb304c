// Your turn, stage 1: a ball falls. Edit mine.hpp (./course check 1 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 1, or once ./course check 1 --watch.
// The lesson: docs/01_free_fall.md. Stuck? ./course check 1 --hint

// The gaps of free_fall.hpp. ./course check makes mine.hpp: each part below takes the
// place of the part of its name there, so it is indented as it is there.
// clang-format off

  // [force]
  // YOUR TURN 1 of 3: the force on the ball [N]. (Lesson: "The idea")
  // You have: mass [kg], gravity [m/s^2, positive]. y is up.
  // Must hold: gravity is the only force, it pulls downwards, and it is the same everywhere.
  double force(double /*t*/, const State<double>& /*state*/) const {
    return 0;  // <- here
  }
  // [force]

  // [acceleration]
  // YOUR TURN 2 of 3: the acceleration that this force causes [m/s^2]. (Lesson: "The idea")
  // You have: force(t, state) [N] from above, mass [kg].
  // Must hold: F = m a, whatever the force and the mass are.
  double acceleration([[maybe_unused]] double t,
                      [[maybe_unused]] const State<double>& state) const {
    return 0;  // <- here
  }
  // [acceleration]

// [loop]
// YOUR TURN 3 of 3: the loop, once around. (Lesson: "The idea")
// You have: scene.acceleration(t, state) [m/s^2], state.position [m], state.velocity [m/s], dt [s].
// Must hold: afterwards `state` is one time step dt later. First the velocity changes, by the
// acceleration at (t, state); then the position, by the *new* velocity. It works for every scene,
// also where a position is a vector (stage 4): so keep an acceleration in a `Vector`, which is
// whatever the scene's positions are. Here that is a double.
template <class Scene, class Vector>
void fall_one_step([[maybe_unused]] const Scene& scene, [[maybe_unused]] double t,
                   [[maybe_unused]] State<Vector>& state, [[maybe_unused]] double dt) {
  // <- here
}
// [loop]

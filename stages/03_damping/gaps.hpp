// Your turn, stage 3: the bounces die out. Edit mine.hpp (./course check 3 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 3, or once ./course check 3 --watch.
// The lesson: docs/03_damping.md. Stuck? ./course check 3 --hint

// The gaps of damping.hpp. ./course check makes mine.hpp: each part below takes the
// place of the part of its name there, so it is indented as it is there.
// clang-format off

  // [force]
  // YOUR TURN: the force on the ball [N], upwards positive. (Lesson: "The idea")
  // You have: what stage 2 had, damping [N s/m], and state.velocity [m/s], upwards positive.
  // Must hold: as in stage 2, and while the ball overlaps the floor (y < radius, not at y = radius)
  // a damper brakes it with damping times its velocity, against the velocity.
  // If contact == ContactLaw::push_only, spring and damper together never pull: their sum is at
  // least 0. Gravity is no part of it. (docs/deeper/03_damping.md: "The damper can pull")
  double force(double /*t*/, [[maybe_unused]] const State<double>& state) const {
    return 0;  // <- here
  }
  // [force]

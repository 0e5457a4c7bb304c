// Your turn, stage 2: the ball bounces. Edit mine.hpp (./course check 2 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 2, or once ./course check 2 --watch.
// The lesson: docs/02_spring_floor.md. Stuck? ./course check 2 --hint

// The gaps of spring_floor.hpp. ./course check makes mine.hpp: each part below takes the
// place of the part of its name there, so it is indented as it is there.
// clang-format off

  // [force]
  // YOUR TURN: the force on the ball [N], upwards positive. (Lesson: "The idea")
  // You have: mass [kg], gravity [m/s^2], radius [m], stiffness [N/m], and state.position [m], the
  // height of the ball's centre. The floor is at height 0.
  // Must hold: gravity acts always. While the ball overlaps the floor (its centre is below the
  // height of its radius) a spring pushes upwards, too, with stiffness times the overlap.
  double force(double /*t*/, [[maybe_unused]] const State<double>& state) const {
    return 0;  // <- here
  }
  // [force]

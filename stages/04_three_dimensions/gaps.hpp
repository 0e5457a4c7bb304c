// Your turn, stage 4: the ball flies in space. Edit mine.hpp (./course check 4 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 4, or once ./course check 4 --watch.
// The lesson: docs/04_three_dimensions.md. Stuck? ./course check 4 --hint

// The gaps of three_dimensions.hpp. ./course check makes mine.hpp: each part below takes the
// place of the part of its name there, so it is indented as it is there.
// clang-format off

  // [force]
  // YOUR TURN 1 of 2: the force on the ball [N], a vector. (Lesson: "The idea")
  // You have: what stage 3 had, state.position and state.velocity as vectors with .x() .y() .z(),
  // and `floor`: whether there is one. y is up. Eigen::Vector3d F(0, 0, 0); makes a vector (without
  // the numbers it holds garbage), and F.y() += 1; changes one part of it.
  // Must hold: gravity acts along y and nowhere else. The floor, where there is one, is
  // frictionless: spring and damper act along y, as in stage 3. With contact ==
  // ContactLaw::push_only the two together never pull.
  Eigen::Vector3d force(double /*t*/, [[maybe_unused]] const State<Eigen::Vector3d>& state) const {
    return {0, 0, 0};  // <- here
  }
  // [force]

  // [acceleration]
  // YOUR TURN 2 of 2: the acceleration [m/s^2]. (Lesson: "The idea")
  // Must hold: F = m a, for the whole vector.
  Eigen::Vector3d acceleration([[maybe_unused]] double t,
                               [[maybe_unused]] const State<Eigen::Vector3d>& state) const {
    return {0, 0, 0};  // <- here
  }
  // [acceleration]

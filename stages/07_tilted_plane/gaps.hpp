// Your turn, stage 7: the floor leans. Edit mine.hpp (./course check 7 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 7, or once ./course check 7 --watch.
// The lesson: docs/07_tilted_plane.md. Stuck? ./course check 7 --hint

// The gaps of tilted_plane.hpp. ./course check makes mine.hpp: each part below takes the
// place of the part of its name there, so it is indented as it is there.
// clang-format off

  // [plane]
  // YOUR TURN 1 of 2: the same plane, with a normal of length 1.
  // (Lesson: "The idea")
  // You have: normal (a, b, c), of any length but zero, and offset d, of a x + b y + c z + d = 0.
  // Must hold: both sides of the equation are divided by the length of the normal, `normal.norm()`.
  // Return {the new normal, the new offset}. The scene's own `normal` stays as it is.
  Plane plane() const {
    return {{0, 0, 0}, 0};  // <- here
  }
  // [plane]

  // [force]
  // YOUR TURN 2 of 2: the force on the ball [N]. (Lesson: "The idea")
  // You have: what stage 4 had, and plane() from above: plane().normal and plane().offset.
  // Must hold: the distance of the ball's centre from the plane is n . p + d, negative behind it;
  // its velocity away from the plane is n . v, where a . b is dot(a, b). While distance < radius,
  // spring and damper push along n, frictionless; with contact == ContactLaw::push_only the two
  // together never pull. Gravity goes on acting along y.
  Eigen::Vector3d force(double /*t*/, [[maybe_unused]] const State<Eigen::Vector3d>& state) const {
    return {0, 0, 0};  // <- here
  }
  // [force]

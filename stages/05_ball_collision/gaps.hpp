// Your turn, stage 5: balls meet balls. Edit mine.hpp (./course check 5 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 5, or once ./course check 5 --watch.
// The lesson: docs/05_ball_collision.md. Stuck? ./course check 5 --hint

// The gaps of ball_collision.hpp. ./course check makes mine.hpp: each part below takes the
// place of the part of its name there, so it is indented as it is there.
// clang-format off

// [meeting]
// YOUR TURN 1 of 3: how two balls touch. (Lesson: "The idea")
// You have: position [m], velocity [m/s] and radius [m] of both balls. `.norm()` is a vector's
// length, `dot(a, b)` the dot product.
// Must hold: overlap = r1 + r2 - d, where d is the distance of the centres. If it is not positive,
// `return {overlap};`. Else e12 has length 1 and points from ball 2 to ball 1, and separation_speed
// is the part of v1 - v2 along it. Where the centres coincide (d <= 1e-100, which is as good as 0),
// e12 is Eigen::Vector3d(0, 1, 0).
inline Meeting meet([[maybe_unused]] const Ball& ball1, [[maybe_unused]] const Ball& ball2) {
  return {0};  // <- here
}
// [meeting]

// [pair]
// YOUR TURN 2 of 3: the force on ball 1 [N]; that on ball 2 is the opposite one.
// (Lesson: "The idea")
// You have: meet(ball1, ball2) from above, and `contact`, which here is spring and damper in one:
// contact.force(overlap, separation_speed) [N] is the push of stage 3, and 0 without overlap.
// Must hold: it acts along e12, and it pushes ball 1 away from ball 2.
inline Eigen::Vector3d pair_force([[maybe_unused]] const Ball& ball1,
                                  [[maybe_unused]] const Ball& ball2,
                                  [[maybe_unused]] const SpringDamper& contact) {
  return {0, 0, 0};  // <- here
}
// [pair]

// [acceleration]
// YOUR TURN 3 of 3: the forces between all balls. Gravity and floor are there.
// (Lesson: "The idea")
// You have: for_each_pair. The braces at its end are a small function, which it calls once for each
// pair, with the numbers i < j of its two balls. In them: ball(state, i), from_ball (the contact),
// and force_.col(i) [N], the force on ball i so far: += and -= change it.
// Must hold: ball i gets pair_force(ball i, ball j, from_ball), and ball j the opposite one.
inline const Eigen::Matrix3Xd& BallCollision::acceleration(double /*t*/,
                                                           const State<Matrix>& state) const {
  const SpringDamper from_floor = floor_contact(), from_ball = pair_contact();
  force_.setZero(3, mass.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    force_(1, i) -= mass[i] * gravity;  // gravity, downwards
    for_each_surface(state.position, i, [&](Eigen::Index axis, double sign, double overlap) {
      force_(axis, i) += sign * from_floor.force(overlap, sign * state.velocity(axis, i));
    });
  }
  for_each_pair(state.position,
                [&]([[maybe_unused]] Eigen::Index i, [[maybe_unused]] Eigen::Index j) {
                  static_cast<void>(from_ball);  // <- here, in place of this line
                });
  for (Eigen::Index i = 0; i < mass.size(); ++i) force_.col(i) /= mass[i];  // a = F / m
  return force_;
}
// [acceleration]

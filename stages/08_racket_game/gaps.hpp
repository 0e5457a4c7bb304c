// Your turn, stage 8: a disc in your hand. Edit mine.hpp (./course check 8 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 8, or once ./course check 8 --watch.
// The lesson: docs/08_racket_game.md. Stuck? ./course check 8 --hint

// The gaps of racket_game.hpp. ./course check makes mine.hpp: each part below takes the
// place of the part of its name there, so it is indented as it is there.
// clang-format off

  // [nearest]
  // YOUR TURN 1 of 2: is the ball on the disc, and where is it nearest? (Lesson: "The idea")
  // You have: racket.centre [m], racket.normal, racket.radius [m] (`radius` alone is the ball's);
  // racket.height(ball) [m], a number: h in the lesson; racket.outwards(ball) [m], a vector along
  // the disc, from its centre to the point below the ball: its .norm() is l in the lesson; `side`,
  // 1 or -1: where the ball comes from.
  // Must hold: return {point, direction, distance}.
  //   over the disc (l < racket.radius): the point below the ball; the normal times side;
  //     the height times side, which is negative when the centre is through the disc.
  //   beside it: the point of the rim that is nearest; from there to the ball, with length 1; and
  //     how far that is. For a ball exactly on the rim: the normal times side, and 0.
  NearestPoint nearest([[maybe_unused]] const Disc& racket,
                       [[maybe_unused]] const Eigen::Vector3d& ball) const {
    return {{0, 0, 0}, {0, 0, 0}, 0};  // <- here
  }
  // [nearest]

  // [force]
  // YOUR TURN 2 of 2: the force on the ball [N]. (Lesson: "The idea")
  // You have: what stage 7 had, disc_at(t), nearest(...) from above, and
  // racket.velocity_of(point) [m/s], how fast that point of the racket moves.
  // Must hold: the law of stage 7 along the direction of nearest(), with the distance from there;
  // the contact law is in it, too.
  // The damper brakes the ball's velocity relative to the point of the racket that it touches.
  Eigen::Vector3d force([[maybe_unused]] double t,
                        [[maybe_unused]] const State<Eigen::Vector3d>& state) const {
    return {0, 0, 0};  // <- here
  }
  // [force]

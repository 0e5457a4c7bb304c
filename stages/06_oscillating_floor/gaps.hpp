// Your turn, stage 6: the floor moves. Edit mine.hpp (./course check 6 makes it):
// fill the gaps marked YOUR TURN. Then run ./course check 6, or once ./course check 6 --watch.
// The lesson: docs/06_oscillating_floor.md. Stuck? ./course check 6 --hint

// The gaps of oscillating_floor.hpp. ./course check makes mine.hpp: each part below takes the
// place of the part of its name there, so it is indented as it is there.
// clang-format off

  // [floor]
  // YOUR TURN 1 of 3: where the floor is [m], and how fast it moves [m/s]. (Lesson: "The idea")
  // You have: floor_velocity [m/s], amplitude [m], angular_frequency [rad/s], phase [rad]; t [s].
  // Must hold: a steady movement from height 0 plus a swing A sin(w t + phase); and the speed is
  // the derivative of the height.
  double floor_height([[maybe_unused]] double t) const {
    return 0;  // <- here
  }
  double floor_speed([[maybe_unused]] double t) const {
    return 0;  // <- and here
  }
  // [floor]

  // [force]
  // YOUR TURN 2 of 3: the force on the ball [N]. (Lesson: "The idea")
  // You have: what stage 3 had (position and velocity are numbers again); floor_height(t) from
  // above; touches and damped_velocity from below: gap 3, which is checked before this one.
  // Must hold: as in stage 3, seen from a floor that is at floor_height(t). The ball is in contact
  // while touches(y, floor); the overlap is measured from where the floor is; the damper brakes
  // damped_velocity(t, v). With contact == ContactLaw::push_only the two together never pull.
  double force([[maybe_unused]] double t, [[maybe_unused]] const State<double>& state) const {
    return 0;  // <- here
  }
  // [force]

  // [laws]
  // YOUR TURN 3 of 3: what the contact knows of the floor's movement.
  // (Lesson: "The idea"; why so: docs/deeper/06_oscillating_floor.md)
  // You have: radius [m], floor_law, and floor_speed(t) [m/s] from above.
  // Must hold: this table.
  //   floor_law               in contact while                   the damper brakes
  //   FloorLaw::relative      ball and floor overlap (not = )    the velocity between the two
  //   FloorLaw::absolute      the same                           the ball's own velocity
  //   FloorLaw::fixed_switch  y < radius, wherever the floor is  the ball's own velocity
  bool touches([[maybe_unused]] double y, [[maybe_unused]] double floor) const {
    return false;  // <- here
  }
  double damped_velocity([[maybe_unused]] double t, [[maybe_unused]] double v) const {
    return 0;  // <- and here
  }
  // [laws]

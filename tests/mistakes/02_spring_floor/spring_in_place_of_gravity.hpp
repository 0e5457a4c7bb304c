// = for +=.
// check: while they overlap, a spring pushes up with k times the overlap
// told: the spring in place of gravity

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  if (y < radius) {
    force = stiffness * (radius - y);
  }
  return force;
}
// [force]

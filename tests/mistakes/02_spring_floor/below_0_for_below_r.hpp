// The ball sinks in up to its centre before anything happens.
// check: while they overlap, a spring pushes up with k times the overlap
// told: y < 0 instead of y < r

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  if (y < 0) {
    force += stiffness * (radius - y);
  }
  return force;
}
// [force]

// The floor sucks the ball in.
// check: while they overlap, a spring pushes up with k times the overlap
// told: the spring on the wrong side

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  if (y < radius) {
    force += stiffness * (y - radius);
  }
  return force;
}
// [force]

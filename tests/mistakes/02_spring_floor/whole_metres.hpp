// The overlap of a small ball is 0 whole metres.
// check: while they overlap, a spring pushes up with k times the overlap
// told: a whole number in place of a double

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  if (y < radius) {
    const int overlap = static_cast<int>(radius - y);
    force += stiffness * overlap;
  }
  return force;
}
// [force]

// A ball that is wholly below the floor goes free.
// check: while they overlap, a spring pushes up with k times the overlap
// told: none of the known mistakes
// seen: wrong where the whole ball is below the surface

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  if (y < radius && y > -radius) {
    force += stiffness * (radius - y);
  }
  return force;
}
// [force]

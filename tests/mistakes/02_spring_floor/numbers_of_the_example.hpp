// Right for the example only.
// check: away from the floor only gravity acts
// told: the example's numbers

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = -9.81;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  if (y < 0.1) {
    force += 1e4 * (0.1 - y);
  }
  return force;
}
// [force]

// An acceleration in place of a force.
// check: away from the floor only gravity acts
// told: mass forgotten

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = -gravity;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  if (y < radius) {
    force += stiffness * (radius - y);
  }
  return force;
}
// [force]

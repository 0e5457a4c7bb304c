// y is up, and so is this gravity.
// check: away from the floor only gravity acts
// told: gravity points up

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = mass * gravity;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  if (y < radius) {
    force += stiffness * (radius - y);
  }
  return force;
}
// [force]

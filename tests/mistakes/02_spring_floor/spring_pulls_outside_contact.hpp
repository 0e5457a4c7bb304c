// No `if`: a rubber band.
// check: away from the floor only gravity acts
// told: the spring pulls outside contact

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, in proportion to the overlap.
  force += stiffness * (radius - y);
  return force;
}
// [force]

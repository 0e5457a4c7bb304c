// The limit comes a line too late.
// check: contact push_only: the push is never below 0, and gravity stays
// told: push_only limits the weight, too

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position, v = state.velocity;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (radius - y) - damping * v;
    force += push;
    if (contact == ContactLaw::push_only) force = std::max(0.0, force);
  }
  return force;
}
// [force]

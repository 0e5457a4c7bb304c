// A jump of c v, a moment too early.
// check: a ball that just touches has no overlap yet
// told: <= instead of <

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position, v = state.velocity;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (y <= radius) {
    double push = stiffness * (radius - y) - damping * v;
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push;
  }
  return force;
}
// [force]

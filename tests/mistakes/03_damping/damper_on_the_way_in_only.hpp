// The damper is there on the way out, too.
// check: while they overlap, spring and damper: k (r - y) - c v
// told: none of the known mistakes
// seen: right in contact at rest and in contact on the way in

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position, v = state.velocity;
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (radius - y) - damping * std::min(0.0, v);
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push;
  }
  return force;
}
// [force]

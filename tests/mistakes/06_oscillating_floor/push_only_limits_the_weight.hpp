// The limit comes a line too late, and in the air as well.
// check: all three floor laws, with both kinds of contact
// told: push_only limits the weight, too

// [force]
double force(double t, const State<double>& state) const {
  const double y = state.position, v = state.velocity;
  const double floor = floor_height(t);
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (touches(y, floor)) {
    double push = stiffness * (radius - y + floor) - damping * damped_velocity(t, v);
    force += push;
  }
  if (contact == ContactLaw::push_only) force = std::max(0.0, force);
  return force;
}
// [force]

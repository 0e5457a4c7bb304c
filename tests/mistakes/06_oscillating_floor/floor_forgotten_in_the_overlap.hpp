// As if the floor was at 0.
// check: in contact: k (r - y + floor) - c (v - floor speed)
// told: the floor's height forgotten in the overlap
// seen: k times the floor's height is missing

// [force]
double force(double t, const State<double>& state) const {
  const double y = state.position, v = state.velocity;
  const double floor = floor_height(t);
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (touches(y, floor)) {
    double push = stiffness * (radius - y) - damping * damped_velocity(t, v);
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push;
  }
  return force;
}
// [force]

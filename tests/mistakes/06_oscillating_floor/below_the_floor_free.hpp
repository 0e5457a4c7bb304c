// A ball that is wholly below the floor goes free.
// check: in contact: k (r - y + floor) - c (v - floor speed)
// told: none of the known mistakes
// seen: where the whole ball is below the surface

// [force]
double force(double t, const State<double>& state) const {
  const double y = state.position, v = state.velocity;
  const double floor = floor_height(t);
  // Gravity, downwards.
  double force = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (touches(y, floor) && y - floor > -radius) {
    double push = stiffness * (radius - y + floor) - damping * damped_velocity(t, v);
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push;
  }
  return force;
}
// [force]

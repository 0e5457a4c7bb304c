// A brake in the air.
// check: away from the floor only gravity acts: no spring, no damper
// told: damper always on

// [force]
double force(double /*t*/, const State<double>& state) const {
  const double y = state.position, v = state.velocity;
  // Gravity, downwards.
  double force = -mass * gravity - damping * v;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (radius - y);
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push;
  }
  return force;
}
// [force]

// The limit comes a line too late.
// check: both kinds of contact, with a floor and without
// told: push_only limits the weight, too

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  const double y = state.position.y(), v = state.velocity.y();
  // Gravity, downwards.
  Eigen::Vector3d force(0, -mass * gravity, 0);
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (floor && y < radius) {
    double push = stiffness * (radius - y) - damping * v;
    force.y() += push;
    if (contact == ContactLaw::push_only) force.y() = std::max(0.0, force.y());
  }
  return force;
}
// [force]

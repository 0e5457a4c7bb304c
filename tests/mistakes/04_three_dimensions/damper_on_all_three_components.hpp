// The floor brakes what slides along it.
// check: the floor pushes along y only: it is frictionless
// told: damper on all three components

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  const double y = state.position.y(), v = state.velocity.y();
  // Gravity, downwards.
  Eigen::Vector3d force(0, -mass * gravity, 0);
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (floor && y < radius) {
    double push = stiffness * (radius - y) + 0.0;
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force.y() += push;
    force -= damping * state.velocity;
  }
  return force;
}
// [force]

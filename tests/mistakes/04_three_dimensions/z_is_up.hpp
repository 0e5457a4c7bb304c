// As in many other programs.
// check: in the air gravity acts, along y only
// told: z is up

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  const double y = state.position.z(), v = state.velocity.z();
  // Gravity, downwards.
  Eigen::Vector3d force(0, 0, -mass * gravity);
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (floor && y < radius) {
    double push = stiffness * (radius - y) - damping * v;
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force.z() += push;
  }
  return force;
}
// [force]

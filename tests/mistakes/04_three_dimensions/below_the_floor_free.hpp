// A ball that is wholly below the floor goes free.
// check: the floor pushes along y only: it is frictionless
// told: none of the known mistakes
// seen: where the whole ball is below the surface

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  const double y = state.position.y(), v = state.velocity.y();
  // Gravity, downwards.
  Eigen::Vector3d force(0, -mass * gravity, 0);
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (floor && y < radius && y > -radius) {
    double push = stiffness * (radius - y) - damping * v;
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force.y() += push;
  }
  return force;
}
// [force]

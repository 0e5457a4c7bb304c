// A vector is not zero by itself.
// check: in the air gravity acts, along y only
// told: a variable that was never given a value
// seen: no value given

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  const double y = state.position.y(), v = state.velocity.y();
  // Gravity, downwards.
  Eigen::Vector3d force;
  force.y() = -mass * gravity;
  // Only while the ball overlaps the floor: a spring, and a damper against the velocity.
  if (floor && y < radius) {
    double push = stiffness * (radius - y) - damping * v;
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force.y() += push;
  }
  return force;
}
// [force]

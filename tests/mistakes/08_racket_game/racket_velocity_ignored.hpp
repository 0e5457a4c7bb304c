// The ball's own velocity: the result depends on who watches.
// check: a racket that moves and turns: the damper sees the velocity between the two
// told: racket velocity ignored
// seen: c times the racket's velocity is missing

// [force]
Eigen::Vector3d force(double t, const State<Eigen::Vector3d>& state) const {
  // Distance of the centre from the racket, and velocity away from the point that is touched.
  const Disc racket = disc_at(t);
  const auto [point, n, y] = nearest(racket, state.position);
  const double v = dot(n, state.velocity);
  // Gravity, downwards.
  Eigen::Vector3d force(0, -mass * gravity, 0);
  // Only while the ball overlaps the racket: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (radius - y) - damping * v;
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push * n;  // along the normal
  }
  return force;
}
// [force]

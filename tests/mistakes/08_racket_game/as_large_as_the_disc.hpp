// Another one's radius.
// check: a racket at rest: gravity, and the law of stage 7 along the push
// told: the disc's radius for the ball's

// [force]
Eigen::Vector3d force(double t, const State<Eigen::Vector3d>& state) const {
  // Distance of the centre from the racket, and velocity away from the point that is touched.
  const Disc racket = disc_at(t);
  const auto [point, n, y] = nearest(racket, state.position);
  const double v = dot(n, state.velocity - racket.velocity_of(point));
  // Gravity, downwards.
  Eigen::Vector3d force(0, -mass * gravity, 0);
  // Only while the ball overlaps the racket: a spring, and a damper against the velocity.
  if (y < radius) {
    double push = stiffness * (racket.radius - y) - damping * v;
    if (contact == ContactLaw::push_only) push = std::max(0.0, push);
    force += push * n;  // along the normal
  }
  return force;
}
// [force]

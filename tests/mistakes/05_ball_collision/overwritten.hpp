// What was there before is lost.
// check: all balls: each pair once, equal and opposite
// told: = in place of += or -=

// [acceleration]
inline const Eigen::Matrix3Xd& BallCollision::acceleration(double /*t*/,
                                                           const State<Matrix>& state) const {
  const SpringDamper from_floor = floor_contact(), from_ball = pair_contact();
  force_.setZero(3, mass.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    force_(1, i) -= mass[i] * gravity;  // gravity, downwards
    for_each_surface(state.position, i, [&](Eigen::Index axis, double sign, double overlap) {
      force_(axis, i) += sign * from_floor.force(overlap, sign * state.velocity(axis, i));
    });
  }
  for_each_pair(state.position, [&](Eigen::Index i, Eigen::Index j) {
    const Eigen::Vector3d force = pair_force(ball(state, i), ball(state, j), from_ball);
    force_.col(i) = force;   // equal
    force_.col(j) -= force;  // and opposite
  });
  for (Eigen::Index i = 0; i < mass.size(); ++i) force_.col(i) /= mass[i];  // a = F / m
  return force_;
}
// [acceleration]

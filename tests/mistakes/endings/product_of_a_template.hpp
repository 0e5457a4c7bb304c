// The compiler finds it in Eigen. The learner is shown the own line all the same.
// stage: 07_tilted_plane
// says: return plane().normal * state.velocity;
// says: Two vectors cannot be multiplied with *

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  return plane().normal * state.velocity;
}
// [force]

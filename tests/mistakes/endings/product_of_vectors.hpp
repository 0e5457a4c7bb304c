// There are several products of vectors, and * is none of them.
// stage: 07_tilted_plane
// says: const double v = plane().normal * state.velocity;
// says: Two vectors cannot be multiplied with *

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  const double v = plane().normal * state.velocity;
  return {0, -mass * gravity - damping * v, 0};
}
// [force]

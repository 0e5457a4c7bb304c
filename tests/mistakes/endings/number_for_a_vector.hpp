// One part only, and nobody knows which.
// stage: 04_three_dimensions
// says: mine.hpp:
// says: A vector is wanted here, and this is a number

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  return state.position.y() < radius ? stiffness * (radius - state.position.y()) : -mass * gravity;
}
// [force]

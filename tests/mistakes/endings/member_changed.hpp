// The setting is not for force() to change.
// stage: 04_three_dimensions
// says: mine.hpp:
// says: A member may not be changed in a function that is marked const

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  stiffness /= mass;
  return {0, stiffness * (radius - state.position.y()) - gravity, 0};
}
// [force]

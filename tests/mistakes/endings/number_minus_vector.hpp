// From stage 4 on a position has three parts.
// stage: 04_three_dimensions
// says: mine.hpp:
// says: A number and a vector cannot be added, subtracted or compared

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  Eigen::Vector3d force(0, -mass * gravity, 0);
  if (state.position.y() < radius) force.y() += (stiffness * (radius - state.position)).y();
  return force;
}
// [force]

// In C++ the comma throws two of the three away.
// stage: 04_three_dimensions
// says: mine.hpp:
// says: (a, b, c) is no vector in C++: write Eigen::Vector3d(a, b, c).

// [force]
Eigen::Vector3d force(double /*t*/, const State<Eigen::Vector3d>& state) const {
  Eigen::Vector3d force = (0, -mass * gravity, 0);
  if (state.position.y() < radius) force.y() += stiffness * (radius - state.position.y());
  return force;
}
// [force]

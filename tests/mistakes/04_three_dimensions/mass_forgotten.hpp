// A force in place of an acceleration.
// check: the acceleration is force / mass, in all three components
// told: mass forgotten

// [acceleration]
Eigen::Vector3d acceleration(double t, const State<Eigen::Vector3d>& state) const {
  return force(t, state);
}
// [acceleration]

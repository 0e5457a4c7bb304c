// A force in place of an acceleration.
// check: the acceleration is force / mass
// told: mass forgotten

// [acceleration]
double acceleration(double t, const State<double>& state) const {
  return force(t, state);  // F = m a, read as cause and effect
}
// [acceleration]
